#include <gtest/gtest.h>

#include <cmath>

#include "unit/metrics_sample.h"

namespace tread::metrics_straight_running_test {
namespace {

using sample::constant;
using sample::errorOf;
using sample::kDegree;
using sample::valueOf;

constexpr double kSpeed = 20, kPull = 0.1, kHeading = 0.3, kDuration = 6;  // m/s, m/s2, rad, s

// Pulled aside with a constant acceleration, turning with it.
Log logOf(double side) {
    const auto aside = [=](double t) { return 0.5 * side * kPull * t * t; };
    return sample::log(
        100, kDuration,
        {{"driver.steering_wheel_angle", "rad", constant(0.02)},
         {"chassis.vx", "m/s", constant(kSpeed)},
         {"chassis.x", "m", [=](double t) { return kSpeed * t * std::cos(kHeading) - aside(t) * std::sin(kHeading); }},
         {"chassis.y", "m", [=](double t) { return kSpeed * t * std::sin(kHeading) + aside(t) * std::cos(kHeading); }},
         {"chassis.yaw", "rad", [=](double t) { return kHeading + (t < 0.25 ? 0 : side * kPull / kSpeed * t); }},
         {"chassis.yaw_rate", "rad/s", constant(side * kPull / kSpeed)},
         {"chassis.ay", "m/s2", constant(side * kPull)},
         {"steering.torque", "N m", [=](double t) { return side * t; }}});
}

TEST(StraightRunning, ReadsDriftAndPull) {
    for (const double side : {1.0, -1.0}) {
        const auto found = metrics(logOf(side), "straight_running");
        const double drift = side * 0.5 * kPull * kDuration * kDuration;
        EXPECT_NEAR(valueOf(found, "drift"), drift, 1e-9);
        EXPECT_NEAR(valueOf(found, "distance"), kSpeed * kDuration, 1e-9);
        EXPECT_NEAR(valueOf(found, "drift_per_100m"), side * 0.5 * kPull * 25, 1e-9) << "after 5 s";
        EXPECT_NEAR(valueOf(found, "yaw_angle"), side * kPull / kSpeed * kDuration / kDegree, 1e-3);
        EXPECT_NEAR(valueOf(found, "last_yaw_rate"), side * kPull / kSpeed / kDegree, 1e-9);
        EXPECT_NEAR(valueOf(found, "last_ay"), side * kPull, 1e-12);
        EXPECT_NEAR(valueOf(found, "hand_torque"), side * (kDuration - 0.5), 1e-9);
        EXPECT_NEAR(valueOf(found, "speed"), kSpeed, 1e-12);
    }
}

TEST(StraightRunning, TorqueIsUndefinedWhenItIsNotLogged) {
    Log log = logOf(1);
    sample::remove(log, "steering.torque");
    EXPECT_TRUE(std::isnan(valueOf(metrics(log, "straight_running"), "hand_torque")));
}

TEST(StraightRunning, SteeringAndBrakingAreRefused) {
    Log log = logOf(1);
    sample::channel(log, "driver.steering_wheel_angle").values.back() = 0.2;
    EXPECT_NE(errorOf(log, "straight_running").find("expected a fixed one"), std::string::npos);
    log = logOf(1);
    sample::channel(log, "chassis.vx").values.back() = 10;
    EXPECT_NE(errorOf(log, "straight_running").find("expected a constant one"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_straight_running_test
