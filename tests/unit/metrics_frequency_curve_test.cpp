#include "metrics/frequency_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace tread::metrics_frequency_curve_test {
namespace {

using Complex = std::complex<double>;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSpacing = 0.05;  // Hz
constexpr double kHighest = 4;     // Hz

FrequencyCurve curveOf(const std::function<Complex(double)>& transfer) {
    FrequencyCurve curve;
    for (int i = 1; i * kSpacing <= kHighest; ++i) curve.push_back({i * kSpacing, transfer(i * kSpacing), 1, 1});
    return curve;
}

constexpr double kCorner = 1.23;  // Hz, between two points
Complex lowPass(double frequency) {
    return 1.0 / Complex(1, frequency / kCorner);
}
// A straight line between points errs by at most h^2 / 8 times the second derivative, which is below 1 / kCorner^2
// here.
constexpr double kStraight = kSpacing * kSpacing / 8 / (kCorner * kCorner);

TEST(FrequencyCurve, ReadsALowPassBetweenItsPoints) {
    const FrequencyCurve curve = curveOf(lowPass);
    for (const double frequency : {0.11, 0.77, 1.0, 2.345, 3.99}) {
        EXPECT_NEAR(gainAt(curve, frequency), std::abs(lowPass(frequency)), kStraight);
        EXPECT_NEAR(phaseLagAt(curve, frequency), std::atan(frequency / kCorner), kStraight);
    }
}

TEST(FrequencyCurve, LowPassHasFallenAndLagsAsKnownAtItsCorner) {
    const FrequencyCurve curve = curveOf(lowPass);
    // The level is passed with a slope of at least a third of 1 / kCorner.
    const double near = 3 * kCorner * kStraight;
    EXPECT_NEAR(frequencyOfGain(curve, 1 / std::numbers::sqrt2), kCorner, near);
    EXPECT_NEAR(frequencyOfLag(curve, std::numbers::pi / 4), kCorner, near);
}

TEST(FrequencyCurve, LagOfADeadTimeGrowsOverWholeTurns) {
    constexpr double kDeadTime = 0.6;  // s: 2.4 turns at the highest frequency
    const FrequencyCurve curve = curveOf([](double f) { return std::polar(1.0, -kTurn * f * kDeadTime); });
    for (const double frequency : {0.5, 1.1, 2.0, 3.7})
        EXPECT_NEAR(phaseLagAt(curve, frequency), kTurn * frequency * kDeadTime, 1e-9);
    EXPECT_NEAR(frequencyOfLag(curve, 2 * kTurn), 2 / kDeadTime, 1e-9);
}

TEST(FrequencyCurve, PeakIsWhereTheGainIsLargest) {
    constexpr double kNatural = 1.5, kDamping = 0.2;
    const FrequencyCurve curve = curveOf([](double f) {
        const double r = f / kNatural;
        return 1.0 / Complex(1 - r * r, 2 * kDamping * r);
    });
    EXPECT_NEAR(peakOf(curve).frequency, kNatural * std::sqrt(1 - 2 * kDamping * kDamping), 0.5 * kSpacing);
}

TEST(FrequencyCurve, OutsideAndNeverPassedAreUndefined) {
    const FrequencyCurve curve = curveOf(lowPass);
    EXPECT_TRUE(std::isnan(gainAt(curve, 0.5 * kSpacing)));
    EXPECT_TRUE(std::isnan(coherenceAt(curve, kHighest + kSpacing)));
    EXPECT_TRUE(std::isnan(frequencyOfGain(curve, 2)));
    EXPECT_TRUE(std::isnan(frequencyOfLag(curve, std::numbers::pi)));
}

}  // namespace
}  // namespace tread::metrics_frequency_curve_test
