#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/metrics_sample.h"

namespace tread::metrics_split_mu_test {
namespace {

using sample::errorOf;
using sample::kDegree;
using sample::kRates;
using sample::valueOf;

constexpr double kOnset = 1, kSpeed = 14, kDeceleration = 4;  // s, m/s, m/s2
constexpr double kStop = kSpeed / kDeceleration;              // s
constexpr double kTrim = 0.1;                                 // rad, of the steering wheel before

// Constant deceleration along y = 0. The driver turns the steering wheel at a constant rate, 1 rad in 2 s, then back at
// half that; the car yaws away and back.
Log logOf(double rate, double side) {
    const auto braked = [](double t) { return std::clamp(t - kOnset, 0.0, kStop); };
    const auto hand = [=](double t) {
        const double s = braked(t);
        return kTrim - side * (s < 2 ? 0.5 * s : 1 - 0.25 * (s - 2));
    };
    const auto yaw = [=](double t) { return side * 0.025 * (1 - std::cos(2 * std::numbers::pi * braked(t) / kStop)); };
    const auto yaw_rate = [=](double t) {
        const double turn = 2 * std::numbers::pi / kStop;
        return side * 0.025 * turn * std::sin(turn * braked(t));
    };
    return sample::log(rate, 6,
                       {{"driver.brake", "-", [](double t) { return t < kOnset ? 0 : 1; }},
                        {"driver.steering_wheel_angle", "rad", hand},
                        {"chassis.vx", "m/s", [=](double t) { return kSpeed - kDeceleration * braked(t); }},
                        {"chassis.x", "m",
                         [=](double t) {
                             return kSpeed * (std::min(t, kOnset) + braked(t)) -
                                    0.5 * kDeceleration * braked(t) * braked(t);
                         }},
                        {"chassis.y", "m", [=](double t) { return side * 0.1 * braked(t); }},
                        {"chassis.yaw", "rad", yaw},
                        {"chassis.yaw_rate", "rad/s", yaw_rate}});
}

TEST(SplitMuBraking, SteeringYawAndStopAreThoseOfTheClosedForms) {
    for (const double rate : kRates) {
        for (const double side : {1.0, -1.0}) {
            const auto found = metrics(logOf(rate, side), "split_mu_braking");
            const double late = 1 / rate;  // the pedal jumps between two samples
            EXPECT_NEAR(valueOf(found, "steering_first_2s"), 1 / kDegree, late * 0.5 / kDegree + 1e-9) << rate;
            EXPECT_NEAR(valueOf(found, "largest_steering"), 1 / kDegree, late * 0.5 / kDegree + 1e-9) << rate;
            EXPECT_NEAR(valueOf(found, "initial_speed"), kSpeed, 1e-9) << rate;
            EXPECT_NEAR(valueOf(found, "stopping_distance"), 0.5 * kSpeed * kStop, late * kSpeed + 1e-9) << rate;
            EXPECT_NEAR(valueOf(found, "mfdd"), kDeceleration, 1e-3 * kDeceleration) << rate;
            EXPECT_NEAR(std::abs(valueOf(found, "lateral_deviation")), 0.1 * kStop, 0.1 * late + 1e-9) << rate;
            EXPECT_NEAR(valueOf(found, "largest_yaw_angle"), 0.05 / kDegree, 0.05 * late / kDegree) << rate;
            EXPECT_NEAR(valueOf(found, "largest_yaw_rate"), 0.05 * std::numbers::pi / kStop / kDegree,
                        0.02 * 0.05 / kDegree)
                << rate;
        }
    }
}

TEST(SplitMuBraking, HandsFixedItIsTheTurnOfTheCar) {
    Log log = logOf(100, 1);
    for (double& angle : sample::channel(log, "driver.steering_wheel_angle").values) angle = 0;
    const auto found = metrics(log, "split_mu_braking");
    EXPECT_EQ(valueOf(found, "largest_steering"), 0);
    EXPECT_GT(valueOf(found, "largest_yaw_angle"), 2);
}

TEST(SplitMuBraking, StraightOnOrInATurnItIsRefused) {
    Log log = logOf(100, 1);
    for (const char* name : {"driver.steering_wheel_angle", "chassis.yaw"})
        for (double& angle : sample::channel(log, name).values) angle = 0;
    EXPECT_NE(errorOf(log, "split_mu_braking").find("expected at least 2 deg"), std::string::npos);
    log = logOf(100, 1);
    for (double& rate : sample::channel(log, "chassis.yaw_rate").values) rate += 0.2;
    EXPECT_NE(errorOf(log, "split_mu_braking").find("is in a turn"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_split_mu_test
