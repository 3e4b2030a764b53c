// Braking in a turn and power-off: a car that does a known thing to its circle.

#include <gtest/gtest.h>

#include <cmath>

#include "unit/metrics_sample.h"

namespace tread::metrics_turn_disturbance_test {
namespace {

using sample::errorOf;
using sample::kDegree;
using sample::kRates;
using sample::valueOf;

constexpr double kOnset = 3, kSpeed = 22, kRadius = 100, kDeceleration = 4;
constexpr double kLate = 0.05;  // s after the onset, at which a car that leaves its circle does so

// From the onset on: speed falls, yaw rate = speed / radius * (1 + growth * time since), sideslip grows by `slip` a
// second. Path by integration in small steps.
struct Disturbed {
    double growth = 0;     // 1/s
    double slip = 0;       // rad/s, the tail out
    double direction = 1;  // +1: to the left
    bool straight = false;

    double speed(double t) const { return t < kOnset ? kSpeed : kSpeed - kDeceleration * (t - kOnset); }
    double yawRate(double t) const {
        if (straight && t >= kOnset + kLate) return 0;
        return direction * speed(t) / kRadius * (t < kOnset ? 1 : 1 + growth * (t - kOnset));
    }
    double sideslip(double t) const { return -direction * (0.01 + (t < kOnset ? 0 : slip * (t - kOnset))); }
};

Log logOf(const Disturbed& d, double rate, bool brake) {
    Log log{{{"time", "s", {}},
             {"driver.steering_wheel_angle", "rad", {}},
             {"driver.throttle", "-", {}},
             {"driver.brake", "-", {}},
             {"chassis.x", "m", {}},
             {"chassis.y", "m", {}},
             {"chassis.yaw", "rad", {}},
             {"chassis.vx", "m/s", {}},
             {"chassis.vy", "m/s", {}},
             {"chassis.yaw_rate", "rad/s", {}},
             {"chassis.ay", "m/s2", {}},
             {"chassis.sideslip", "rad", {}}}};
    double x = 0, y = 0, course = 0;
    constexpr double kStep = 1e-4;
    const auto every = static_cast<long>(std::lround(1 / (rate * kStep)));
    for (long k = 0; static_cast<double>(k) * kStep < kOnset + 3; ++k) {
        const double t = static_cast<double>(k) * kStep;
        if (k % every == 0) {
            const double s = d.sideslip(t), v = d.speed(t);
            const double row[] = {t,
                                  d.direction * 0.9,
                                  brake ? 0.2 : (t < kOnset ? 0.3 : std::max(0.0, 0.3 - 6 * (t - kOnset))),
                                  brake && t >= kOnset ? std::min(0.4, 8 * (t - kOnset)) : 0.0,
                                  x,
                                  y,
                                  course - s,
                                  v * std::cos(s),
                                  v * std::sin(s),
                                  d.yawRate(t),
                                  v * d.yawRate(t),
                                  s};
            for (std::size_t i = 0; i < log.channels.size(); ++i) log.channels[i].values.push_back(row[i]);
        }
        // The path's own turning: yaw rate and what sideslip adds to it do not matter for the closed form of a circle.
        const double turn = d.yawRate(t + 0.5 * kStep), v = d.speed(t + 0.5 * kStep);
        x += kStep * v * std::cos(course + 0.5 * kStep * turn);
        y += kStep * v * std::sin(course + 0.5 * kStep * turn);
        course += kStep * turn;
    }
    return log;
}

TEST(BrakingInTurn, ReadsYawRateSideslipAndSpeedASecondAfterTheBrake) {
    for (const double rate : kRates) {
        for (const double direction : {1.0, -1.0}) {
            const auto found =
                metrics(logOf({.growth = 0.2, .slip = 0.03, .direction = direction}, rate, true), "braking_in_turn");
            // The onset is where the pedal passes 2 %: within a sample of the true one.
            const double late = 0.0025 + 0.5 / rate;
            EXPECT_NEAR(valueOf(found, "yaw_rate_ratio"), 1.2, 0.2 * late + 0.002) << rate;
            EXPECT_NEAR(valueOf(found, "ay_ratio"), 1.2, 0.2 * late + 0.002) << rate;
            EXPECT_NEAR(valueOf(found, "mean_deceleration"), kDeceleration, kDeceleration * (late + 0.002)) << rate;
            EXPECT_NEAR(valueOf(found, "sideslip_change"), 0.03 / kDegree, 0.03 / kDegree * (late + 0.01)) << rate;
            EXPECT_NEAR(valueOf(found, "speed"), kSpeed, 0.01);
            EXPECT_NEAR(valueOf(found, "radius"), kRadius, 0.1);
            EXPECT_NEAR(valueOf(found, "ay"), direction * kSpeed * kSpeed / kRadius, 0.01);
            EXPECT_EQ(valueOf(found, "steering_range"), 0);
            // Yaw rate / (v / R) grows to 1.6 after three seconds.
            EXPECT_NEAR(valueOf(found, "peak_yaw_rate_ratio"), 1.6, 0.02) << rate;
        }
    }
}

TEST(BrakingInTurn, PathDeviationIsMeasuredFromTheCircle) {
    for (const double direction : {1.0, -1.0}) {
        EXPECT_NEAR(valueOf(metrics(logOf({.direction = direction}, 100, true), "braking_in_turn"), "path_deviation"),
                    0, 0.01)
            << "stays on its circle";
        const double way = kSpeed * (1 - kLate) - 0.5 * kDeceleration * (1 - kLate * kLate);
        EXPECT_NEAR(valueOf(metrics(logOf({.direction = direction, .straight = true}, 100, true), "braking_in_turn"),
                            "path_deviation"),
                    kRadius - std::hypot(kRadius, way), 0.02)
            << "runs off along the tangent, outwards";
    }
}

TEST(BrakingInTurn, NoTurnAndNoBrakeAreRefused) {
    Log log = logOf({}, 100, true);
    for (double& value : sample::channel(log, "chassis.yaw_rate").values) value = 0;
    EXPECT_NE(errorOf(log, "braking_in_turn").find("expected a turn"), std::string::npos);
    EXPECT_NE(errorOf(logOf({}, 100, false), "braking_in_turn").find("never applied"), std::string::npos);
}

TEST(PowerOff, ReadsASecondAfterTheThrottleIsReleased) {
    for (const double rate : kRates) {
        const auto found = metrics(logOf({.growth = 0.1, .slip = -0.01}, rate, false), "power_off");
        // Time zero is half the release, 0.025 s after its beginning.
        const double late = 0.025 + 0.5 / rate;
        EXPECT_NEAR(valueOf(found, "yaw_rate_ratio"), 1.1, 0.1 * late + 0.002) << rate;
        EXPECT_NEAR(valueOf(found, "mean_deceleration"), kDeceleration, kDeceleration * (late + 0.005)) << rate;
        EXPECT_NEAR(valueOf(found, "sideslip_change"), -0.01 / kDegree, 0.03) << rate;
        // d(yaw rate)/dt at the release: -a/R + growth * v/R; over half a second the products with t add their share.
        const double half = (kSpeed - 0.5 * kDeceleration) / kRadius * 1.05 - kSpeed / kRadius;
        EXPECT_NEAR(valueOf(found, "yaw_acceleration"), half / 0.5 / kDegree, 0.1) << rate;
    }
}

TEST(PowerOff, BrakingIsAnotherManoeuvre) {
    Log log = logOf({}, 100, false);
    for (double& value : sample::channel(log, "driver.brake").values) value = 0.3;
    EXPECT_NE(errorOf(log, "power_off").find("braked as well"), std::string::npos);
    EXPECT_NE(errorOf(logOf({}, 100, true), "power_off").find("not released"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_turn_disturbance_test
