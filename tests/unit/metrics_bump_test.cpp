#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/metrics_sample.h"

namespace tread::metrics_bump_test {
namespace {

using sample::constant;
using sample::errorOf;
using sample::kDegree;
using sample::valueOf;

constexpr double kStart = 1, kLoad = 4000;  // s, N
constexpr double kDecay = 3, kFrequency = 2 * std::numbers::pi * 1.5;

// A ring that begins at kStart and dies out.
std::function<double(double)> ring(double level, double size) {
    return [=](double t) {
        const double s = t - kStart;
        return s < 0 ? level : level + size * std::exp(-kDecay * s) * std::sin(kFrequency * s);
    };
}

// One wheel leaves the road for 0.1 s, the others feel little.
Log logOf(double rate) {
    const auto lifted = [](double t) {
        if (t < kStart) return kLoad;
        return t < kStart + 0.1 ? 2 * kLoad : t < kStart + 0.2 ? 0.0 : kLoad;
    };
    return sample::log(rate, 5,
                       {{"chassis.vx", "m/s", constant(11)},
                        {"chassis.ax", "m/s2", constant(0)},
                        {"chassis.az", "m/s2", ring(0, 6)},
                        {"chassis.pitch_rate", "rad/s", ring(0, 0.2)},
                        {"chassis.roll_rate", "rad/s", constant(0.05)},
                        {"wheel.front_left.load", "N", lifted},
                        {"wheel.front_right.load", "N", constant(kLoad)},
                        {"wheel.rear_left.load", "N", constant(3000)},
                        {"wheel.rear_right.load", "N", constant(3000)},
                        {"wheel.front_left.travel", "m", ring(0.01, 0.04)}});
}

// First extremum of the ring: where tan(w s) = w / decay.
double firstPeak(double size) {
    const double s = std::atan(kFrequency / kDecay) / kFrequency;
    return size * std::exp(-kDecay * s) * std::sin(kFrequency * s);
}
double secondPeak(double size) {
    return -firstPeak(size) * std::exp(-kDecay * std::numbers::pi / kFrequency);
}

TEST(BumpMetrics, AreThoseOfARingThatDiesOut) {
    const auto found = metrics(logOf(1000), "bump");
    EXPECT_NEAR(valueOf(found, "speed"), 11, 1e-12);
    EXPECT_NEAR(valueOf(found, "highest_az"), firstPeak(6), 1e-4);
    EXPECT_NEAR(valueOf(found, "lowest_az"), secondPeak(6), 1e-4);
    EXPECT_NEAR(valueOf(found, "peak_pitch_rate"), firstPeak(0.2) / kDegree, 1e-3);
    EXPECT_NEAR(valueOf(found, "peak_roll_rate"), 0.05 / kDegree, 1e-9);
    EXPECT_NEAR(valueOf(found, "highest_load"), 2, 1e-12);
    EXPECT_NEAR(valueOf(found, "lowest_load"), 0, 1e-12);
    EXPECT_NEAR(valueOf(found, "off_the_road"), 0.1, 0.0021);
    EXPECT_NEAR(valueOf(found, "compression"), 1000 * firstPeak(0.04), 1e-2);
    EXPECT_NEAR(valueOf(found, "rebound"), -1000 * secondPeak(0.04), 1e-2);
}

TEST(BumpMetrics, SettlingEndsWhenTheRingFallsBelowTheLimit) {
    const auto found = metrics(logOf(1000), "bump");
    // The last crossing of 0.5 m/s2 lies within the half-wave whose peak is the last above it.
    double last = 0;
    for (double s = 0; s < 4; s += 1e-4) {
        if (std::abs(6 * std::exp(-kDecay * s) * std::sin(kFrequency * s)) > 0.5) last = s;
    }
    EXPECT_NEAR(valueOf(found, "settling_time"), last, 2e-3);
}

TEST(BumpMetrics, BrakingAndEvenRoadsAreRefused) {
    Log log = logOf(200);
    for (double& value : sample::channel(log, "chassis.ax").values) value = -4;
    EXPECT_NE(errorOf(log, "bump").find("chassis.ax reaches 4"), std::string::npos);
    log = logOf(200);
    for (double& value : sample::channel(log, "wheel.front_left.load").values) value = kLoad;
    EXPECT_NE(errorOf(log, "bump").find("no wheel load changes"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_bump_test
