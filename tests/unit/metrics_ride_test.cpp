#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "metrics/vibration_weighting.h"
#include "metrics_sample.h"

namespace tread::metrics_ride_test {
namespace {

using namespace sample;

constexpr double kTurn = 2 * std::numbers::pi;

// ISO 2631-1:1997, table 3: weights in thousandths at nominal third-octave frequencies. Its own rounding, and that of
// the nominal frequencies, is within 1 %.
TEST(VibrationWeighting, IsThatOfTheTableOfTheStandard) {
    struct Row {
        double frequency, wk, wd;
    };
    for (const Row& row : {Row{0.5, 418, 853},
                           {0.63, 459, 944},
                           {0.8, 477, 992},
                           {1, 482, 1011},
                           {1.6, 494, 968},
                           {2, 531, 890},
                           {2.5, 631, 776},
                           {3.15, 804, 642},
                           {4, 967, 512},
                           {5, 1039, 409},
                           {6.3, 1054, 323},
                           {8, 1036, 253},
                           {12.5, 902, 161},
                           {20, 636, 100},
                           {25, 513, 80},
                           {31.5, 405, 63.2},
                           {40, 314, 49.4},
                           {50, 246, 38.8},
                           {63, 186, 29.5}}) {
        const double exact = std::pow(10, std::round(10 * std::log10(row.frequency)) / 10);
        EXPECT_NEAR(1000 * vibrationWeight(VibrationWeighting::Wk, exact), row.wk, 0.013 * row.wk) << row.frequency;
        EXPECT_NEAR(1000 * vibrationWeight(VibrationWeighting::Wd, exact), row.wd, 0.013 * row.wd) << row.frequency;
    }
}

TEST(VibrationWeighting, SineHasItsAmplitudeTimesItsWeight) {
    for (const double frequency : {1.0, 5.0, 12.0}) {
        const Log sine = log(
            400, 60, {{"chassis.az", "m/s2", [&](double t) { return 0.3 + 0.8 * std::sin(kTurn * frequency * t); }}});
        const TimeSeries series{sine.channels[0].values, sine.channels[1].values};
        const double expected = 0.8 / std::sqrt(2) * vibrationWeight(VibrationWeighting::Wk, frequency);
        EXPECT_NEAR(weightedRms(series, VibrationWeighting::Wk), expected, 0.01 * expected) << frequency;
    }
}

Log rideLog(double rate, double shaking, double steering) {
    return log(rate, 42,
               {{"chassis.vx", "m/s", constant(20)},
                {"driver.steering_wheel_angle", "rad", [=](double t) { return steering * std::sin(t); }},
                {"chassis.ax", "m/s2", constant(0.1)},
                {"chassis.ay", "m/s2", [=](double t) { return 0.5 * std::sin(kTurn * t); }},
                {"chassis.az", "m/s2", [=](double t) { return shaking * std::sin(kTurn * 5 * t); }},
                {"wheel.front_left.load", "N", [](double t) { return 4000 + 1000 * std::sin(kTurn * 2 * t); }},
                {"wheel.rear_right.load", "N", constant(3000)},
                {"wheel.front_left.travel", "m", [](double t) { return 0.01 * std::sin(kTurn * 2 * t); }}});
}

TEST(RideMetrics, AreThoseOfTheSines) {
    for (const double rate : kRates) {
        const auto found = metrics(rideLog(rate, 1, 0), "ride");
        const double vertical = 1.039 / std::sqrt(2), lateral = 0.5 * 1.011 / std::sqrt(2);
        const double near = rate < 100 ? 0.02 : 0.01;  // ten samples a period
        EXPECT_NEAR(valueOf(found, "speed"), 72, 1e-9);
        EXPECT_NEAR(valueOf(found, "vertical_weighted"), vertical, near * vertical);
        EXPECT_NEAR(valueOf(found, "lateral_weighted"), lateral, near * lateral);
        EXPECT_NEAR(valueOf(found, "longitudinal_weighted"), 0, 1e-9);
        EXPECT_NEAR(valueOf(found, "total_weighted"), std::hypot(vertical, lateral), near);
        EXPECT_NEAR(valueOf(found, "load_variation_front_left"), 25 / std::sqrt(2), 0.2);
        EXPECT_NEAR(valueOf(found, "load_variation_rear_right"), 0, 1e-9);
        EXPECT_TRUE(std::isnan(valueOf(found, "load_variation_rear_left"))) << "it is not in the log";
        EXPECT_NEAR(valueOf(found, "lowest_load"), 75, 0.5);
        EXPECT_NEAR(valueOf(found, "travel"), 10 / std::sqrt(2), 0.1);
    }
}

TEST(RideMetrics, SmoothRoadAndSteeringAreNoRide) {
    EXPECT_NE(errorOf(rideLog(100, 0.001, 0), "ride").find("weighted vertical acceleration is"), std::string::npos);
    EXPECT_NE(errorOf(rideLog(100, 1, 0.3), "ride").find("the steering wheel turns by"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_ride_test
