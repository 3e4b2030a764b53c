#include <gtest/gtest.h>

#include <cmath>

#include "unit/metrics_sample.h"

namespace tread::metrics_crosswind_test {
namespace {

using sample::errorOf;
using sample::kDegree;
using sample::kRates;
using sample::valueOf;

constexpr double kWind = 1.5, kPush = 0.8, kHeading = 0.4;  // s, m/s2, rad

// What the wind does at once, and what only after a while.
double rise(double since) {
    return 1 - 0.2 * std::exp(-3 * since);
}

// Pushed aside with constant acceleration from the wind on, turning into it at a constant rate.
Log logOf(double rate, double side) {
    const auto since = [](double t) { return std::max(0.0, t - kWind); };
    const auto aside = [=](double t) { return side * 0.5 * kPush * since(t) * since(t); };
    return sample::log(
        rate, 5,
        {{"driver.steering_wheel_angle", "rad", sample::constant(0.01)},
         {"chassis.vx", "m/s", sample::constant(27.8)},
         {"chassis.x", "m", [=](double t) { return 27.8 * t * std::cos(kHeading) - aside(t) * std::sin(kHeading); }},
         {"chassis.y", "m", [=](double t) { return 27.8 * t * std::sin(kHeading) + aside(t) * std::cos(kHeading); }},
         {"chassis.yaw", "rad", [=](double t) { return kHeading - side * 0.02 * since(t); }},
         {"chassis.yaw_rate", "rad/s", [=](double t) { return t < kWind ? 0 : -side * 0.02 * rise(t - kWind); }},
         {"chassis.ay", "m/s2", [=](double t) { return t < kWind ? 0 : side * kPush * rise(t - kWind); }}});
}

TEST(Crosswind, ReadsPathAndHeadingTwoSecondsAfterTheWind) {
    for (const double rate : kRates) {
        for (const double side : {1.0, -1.0}) {
            const auto found = metrics(logOf(rate, side), "crosswind");
            const double late = 1 / rate;  // the onset lies between two samples
            EXPECT_NEAR(valueOf(found, "path_deviation"), 0.5 * kPush * 4, 2 * kPush * late) << rate;
            EXPECT_NEAR(valueOf(found, "yaw_angle"), -0.04 / kDegree, 0.02 * late / kDegree + 1e-9) << rate;
            EXPECT_NEAR(valueOf(found, "peak_yaw_rate"), -0.02 * rise(2) / kDegree, 1e-4) << rate;
            EXPECT_NEAR(valueOf(found, "peak_ay"), kPush * rise(2), 1e-4) << rate;
            EXPECT_NEAR(valueOf(found, "speed"), 27.8, 1e-9);
        }
    }
}

TEST(Crosswind, SteeringAndCalmAirAreRefused) {
    Log log = logOf(100, 1);
    sample::channel(log, "driver.steering_wheel_angle").values.back() = 0.2;
    EXPECT_NE(errorOf(log, "crosswind").find("expected fixed steering"), std::string::npos);
    log = logOf(100, 1);
    for (double& value : sample::channel(log, "chassis.ay").values) value = 0;
    EXPECT_NE(errorOf(log, "crosswind").find("stays below"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_crosswind_test
