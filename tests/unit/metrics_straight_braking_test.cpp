#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "metrics_sample.h"

namespace tread::metrics_straight_braking_test {
namespace {

using namespace sample;

constexpr double kOnset = 1.0;    // s
constexpr double kBuildUp = 0.2;  // s in which the deceleration rises linearly
constexpr double kDeceleration = 8;
constexpr double kSpeed = 100 / 3.6;

// Constant speed, deceleration building up linearly, constant deceleration, standstill.
double speedAt(double t) {
    const double braked = std::max(0.0, t - kOnset);
    const double lost = braked < kBuildUp ? 0.5 * kDeceleration / kBuildUp * braked * braked
                                          : kDeceleration * (braked - 0.5 * kBuildUp);
    return std::max(0.0, kSpeed - lost);
}
constexpr double kStoppingTime = kSpeed / kDeceleration + 0.5 * kBuildUp;
// Over the build-up, then v^2 / (2 a) from what is left.
constexpr double kAfter = kSpeed - 0.5 * kDeceleration * kBuildUp;
constexpr double kDistance =
    kSpeed * kBuildUp - kDeceleration * kBuildUp * kBuildUp / 6 + kAfter * kAfter / (2 * kDeceleration);
constexpr double kYaw = 0.3;     // rad, heading of the stop
constexpr double kDrift = 0.02;  // m to the left per m forward

double pathAt(double t) {
    const double braked = std::clamp(t - kOnset, 0.0, kStoppingTime);
    const double first = std::min(braked, kBuildUp), rest = std::max(0.0, braked - kBuildUp);
    return kSpeed * (std::min(t, kOnset) + first) - kDeceleration / kBuildUp * first * first * first / 6 +
           kAfter * rest - 0.5 * kDeceleration * rest * rest;
}

Log stopLog(double rate) {
    return log(rate, 6,
               {{"driver.brake", "-", [](double t) { return std::clamp((t - kOnset) / kBuildUp, 0.0, 1.0); }},
                {"driver.steering_wheel_angle", "rad", constant(0.02)},
                {"chassis.vx", "m/s", speedAt},
                {"chassis.ax", "m/s2",
                 [](double t) {
                     const double braked = std::clamp((t - kOnset) / kBuildUp, 0.0, 1.0);
                     return t < kOnset + kStoppingTime ? -kDeceleration * braked : 0;
                 }},
                {"chassis.x", "m", [](double t) { return pathAt(t) * (std::cos(kYaw) - kDrift * std::sin(kYaw)); }},
                {"chassis.y", "m", [](double t) { return pathAt(t) * (std::sin(kYaw) + kDrift * std::cos(kYaw)); }},
                {"chassis.yaw", "rad", constant(kYaw)}});
}

TEST(StraightBraking, ClosedFormsAreFoundAtAnySamplingRate) {
    for (const double rate : kRates) {
        const auto found = metrics(stopLog(rate), "straight_braking");
        // Actuation is taken at a thousandth of the pedal; the speed is a parabola during the build-up only, whose
        // straight pieces miss dt^2 / 12 of its bend.
        const double onset = 0.001 * kBuildUp, bend = kDeceleration / (12 * rate * rate);
        EXPECT_NEAR(valueOf(found, "initial_speed"), kSpeed, 1e-3);
        EXPECT_NEAR(valueOf(found, "stopping_time"), kStoppingTime, onset + 1e-9) << rate;
        EXPECT_NEAR(valueOf(found, "stopping_distance"), kDistance, kSpeed * onset + bend) << rate;
        EXPECT_NEAR(valueOf(found, "mfdd"), kDeceleration, 1e-6) << rate;
        EXPECT_NEAR(valueOf(found, "mean_deceleration"), kSpeed / kStoppingTime, 0.005);
        EXPECT_NEAR(valueOf(found, "peak_deceleration"), kDeceleration, 1e-9);
        EXPECT_NEAR(valueOf(found, "lateral_deviation"), kDrift * kDistance, 0.002);
    }
}

// A car that comes to rest swings back: a jerk that is no braking.
TEST(StraightBraking, ThePeakLeavesOutTheJerkOfComingToRest) {
    Log log = stopLog(1000);
    const Channel& vx = channel(log, "chassis.vx");
    Channel& ax = channel(log, "chassis.ax");
    for (std::size_t i = 0; i < vx.values.size(); ++i) {
        if (vx.values[i] < 0.09 * kSpeed && vx.values[i] > 0) ax.values[i] = -2 * kDeceleration;
    }
    EXPECT_NEAR(valueOf(metrics(log, "straight_braking"), "peak_deceleration"), kDeceleration, 1e-9);
    for (std::size_t i = 0; i < vx.values.size(); ++i) {
        if (vx.values[i] > 0.5 * kSpeed && vx.values[i] < 0.51 * kSpeed) ax.values[i] = -1.5 * kDeceleration;
    }
    EXPECT_NEAR(valueOf(metrics(log, "straight_braking"), "peak_deceleration"), 1.5 * kDeceleration, 1e-9);
}

TEST(StraightBraking, TheDistanceIsCorrectedToTheNextWholeTenOfKmh) {
    Log log = stopLog(1000);
    for (double& v : channel(log, "chassis.vx").values) v *= 0.98;
    const auto found = metrics(log, "straight_braking");
    EXPECT_NEAR(valueOf(found, "corrected_stopping_distance"), 0.98 * kDistance / (0.98 * 0.98), 0.06)
        << "98 km/h counts as 100";
}

// MFDD is an average over distance: with a deceleration that changes with speed it is not the average over time.
TEST(StraightBraking, MfddIsTheAverageOverDistance) {
    // a = k v, so v falls exponentially and the distance between two speeds is (vb - ve) / k.
    const double k = 0.6, v0 = 30;
    const Log log =
        sample::log(1000, 20,
                    {{"driver.brake", "-", [](double t) { return t < 0.9995 ? 0.0 : 1.0; }},
                     {"chassis.vx", "m/s", [=](double t) { return t < 1 ? v0 : v0 * std::exp(-k * (t - 1)); }}});
    const double expected = (0.64 - 0.01) * v0 * v0 / (2 * (0.8 - 0.1) * v0 / k);
    EXPECT_NEAR(valueOf(metrics(log, "straight_braking"), "mfdd"), expected, 1e-3 * expected);
}

TEST(StraightBraking, LockedWheelsAreReportedByTheirShareOfTime) {
    for (const double rate : kRates) {
        Log log = stopLog(rate);
        const double until = kOnset + kStoppingTime - 1 / kDeceleration;  // 1 m/s
        const double locks = kOnset + 0.25 * (until - kOnset);
        for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"}) {
            const bool rear = wheel[0] == 'r';
            log.channels.push_back({std::string("wheel.") + wheel + ".spin", "rad/s", {}});
            for (double t : log.channels[0].values) {
                log.channels.back().values.push_back(rear && t >= locks ? 0 : 0.97 * speedAt(t) / 0.3);
            }
        }
        const auto found = metrics(log, "straight_braking");
        EXPECT_NEAR(valueOf(found, "locked_share_rear_left"), 0.75, 0.6 / rate) << "from spin";
        EXPECT_EQ(valueOf(found, "locked_share_front_left"), 0);
        log.channels.push_back({"wheel.front_left.slip_ratio", "-", std::vector<double>(log.samples(), -1.0)});
        EXPECT_NEAR(valueOf(metrics(log, "straight_braking"), "locked_share_front_left"), 1, 1e-12)
            << "a logged slip ratio counts before the spin";
    }
}

TEST(StraightBraking, MeasurementNoiseMovesTheMetricsLittle) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Log log = stopLog(100);
        addNoise(log, "chassis.vx", 0.03, seed);
        addNoise(log, "driver.brake", 0.002, seed + 150);
        addNoise(log, "chassis.ax", 0.1, seed + 50);
        log.channels.push_back({"chassis.vy", "m/s", std::vector<double>(log.samples(), 0)});
        addNoise(log, "chassis.vy", 0.03, seed + 100);
        const auto found = metrics(log, "straight_braking");
        EXPECT_NEAR(valueOf(found, "stopping_distance"), kDistance, 0.1) << seed;
        EXPECT_NEAR(valueOf(found, "stopping_time"), kStoppingTime, 0.02) << seed;
        EXPECT_NEAR(valueOf(found, "mfdd"), kDeceleration, 0.03) << seed;
        EXPECT_NEAR(valueOf(found, "peak_deceleration"), kDeceleration, 0.3) << seed;
    }
}

TEST(StraightBraking, WhatIsNoStopIsRefusedWithTheReason) {
    Log unbraked = stopLog(100);
    for (double& brake : channel(unbraked, "driver.brake").values) brake = 0;
    EXPECT_EQ(errorOf(unbraked, "straight_braking"), "no straight_braking in this log: the brake is never applied");
    Log slowed = stopLog(100);
    for (double& v : channel(slowed, "chassis.vx").values) v = std::max(v, 5.0);
    EXPECT_EQ(errorOf(slowed, "straight_braking"),
              "no straight_braking in this log: the car is braked from 27.8 m/s but does not stop (slowest 5 m/s)");
    Log turning = stopLog(100);
    for (std::size_t i = 200; i < 300; ++i) channel(turning, "driver.steering_wheel_angle").values[i] = 1;
    EXPECT_NE(errorOf(turning, "straight_braking").find("turns by more than 20 deg"), std::string::npos);
    Log circling = stopLog(100);
    circling.channels.push_back({"chassis.yaw_rate", "rad/s", std::vector<double>(circling.samples(), 0.1)});
    EXPECT_EQ(errorOf(circling, "straight_braking"),
              "no straight_braking in this log: the car is in a turn of 2.8 m/s2 when it is braked");
    Log bare = stopLog(100);
    remove(bare, "driver.brake");
    EXPECT_EQ(errorOf(bare, "straight_braking"),
              "no straight_braking in this log: it needs driver.brake, which the log does not have");
}

}  // namespace
}  // namespace tread::metrics_straight_braking_test
