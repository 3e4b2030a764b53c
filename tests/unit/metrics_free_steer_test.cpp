#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/metrics_sample.h"

namespace tread::metrics_free_steer_test {
namespace {

using sample::errorOf;
using sample::kDegree;
using sample::kRates;
using sample::valueOf;

constexpr double kRelease = 2, kYawRate = 0.12, kAngle = 0.5;  // s, rad/s, rad

// Steady up to the release, then the decay of the yaw rate and, twice as large in its swing, of the steering wheel.
Log logOf(double rate, double side, const std::function<double(double)>& decay) {
    const auto after = [=](double t) { return t < kRelease ? 1 : decay(t - kRelease); };
    return sample::log(rate, 10,
                       {{"driver.hands_off", "-", [](double t) { return t < kRelease ? 0 : 1; }},
                        {"driver.steering_wheel_angle", "rad", [=](double t) { return side * kAngle * after(t); }},
                        {"chassis.vx", "m/s", sample::constant(20)},
                        {"chassis.yaw_rate", "rad/s", [=](double t) { return side * kYawRate * after(t); }},
                        {"chassis.ay", "m/s2", [=](double t) { return side * 20 * kYawRate * after(t); }}});
}

TEST(FreeSteer, AnExponentialDecaySettlesAfterItsTimeConstantTimesTheLogarithm) {
    constexpr double kTime = 0.4;
    for (const double rate : kRates) {
        for (const double side : {1.0, -1.0}) {
            const auto found = metrics(logOf(rate, side, [](double t) { return std::exp(-t / kTime); }), "free_steer");
            const double late = 1 / rate;  // the release lies between two samples
            EXPECT_NEAR(valueOf(found, "settling_time"), kTime * std::log(10), late) << rate;
            EXPECT_NEAR(valueOf(found, "yaw_rate_left"), std::exp(-1 / kTime), late) << rate;
            EXPECT_EQ(valueOf(found, "yaw_rate_overshoot"), 0);
            EXPECT_EQ(valueOf(found, "steering_overshoot"), 0);
            EXPECT_NEAR(valueOf(found, "yaw_rate"), side * kYawRate / kDegree, 1e-9);
            EXPECT_NEAR(valueOf(found, "steering_angle"), side * kAngle / kDegree, 1e-9);
            EXPECT_NEAR(valueOf(found, "ay"), side * 20 * kYawRate, 1e-9);
            EXPECT_NEAR(valueOf(found, "speed"), 20, 1e-9);
        }
    }
}

TEST(FreeSteer, ADampedOscillationOvershootsAsItsClosedForm) {
    // exp(-d t) cos(w t) turns where tan(w t) = -d / w.
    constexpr double kDamping = 1.2, kFrequency = 5;
    const double turn = (std::numbers::pi - std::atan(kDamping / kFrequency)) / kFrequency;
    const double overshoot = -std::exp(-kDamping * turn) * std::cos(kFrequency * turn);
    const auto found = metrics(
        logOf(200, 1, [](double t) { return std::exp(-kDamping * t) * std::cos(kFrequency * t); }), "free_steer");
    EXPECT_NEAR(valueOf(found, "yaw_rate_overshoot"), overshoot, 1e-3);
    EXPECT_NEAR(valueOf(found, "steering_overshoot"), overshoot, 1e-3);
    EXPECT_NEAR(valueOf(found, "last_steering_angle"),
                kAngle / kDegree * std::exp(-kDamping * 8) * std::cos(kFrequency * 8), 1e-9);
}

TEST(FreeSteer, ACarThatGoesOnTurningHasNoSettlingTime) {
    const auto found = metrics(logOf(100, 1, [](double) { return 0.5; }), "free_steer");
    EXPECT_TRUE(std::isnan(valueOf(found, "settling_time")));
}

TEST(FreeSteer, HandsThatStayAndStraightAheadAreRefused) {
    Log log = logOf(100, 1, [](double t) { return std::exp(-t); });
    for (double& value : sample::channel(log, "driver.hands_off").values) value = 0;
    EXPECT_NE(errorOf(log, "free_steer").find("is not released for good"), std::string::npos);
    log = logOf(100, 1, [](double) { return 0; });
    for (double& value : sample::channel(log, "chassis.yaw_rate").values) value = 0;
    EXPECT_NE(errorOf(log, "free_steer").find("before the release"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_free_steer_test
