#include <gtest/gtest.h>

#include <cmath>

#include "metrics_sample.h"

namespace tread::metrics_step_steer_test {
namespace {

using namespace sample;

constexpr double kOnset = 1.0, kRamp = 0.15;   // s
constexpr double kAngle = 0.6;                 // rad at the steering wheel
constexpr double kOmega = 6, kDamping = 0.55;  // of the yaw rate
constexpr double kLag = 0.2;                   // s, of the lateral acceleration
constexpr double kYawGain = 0.5, kAyGain = 7, kSlip = -0.02, kRollGain = 0.007;

// Unit-gain answers to a unit ramp that begins at 0 (zero before).
double secondOrderRamp(double t) {
    if (t <= 0) return 0;
    const double damped = kOmega * std::sqrt(1 - kDamping * kDamping);
    return t - 2 * kDamping / kOmega +
           std::exp(-kDamping * kOmega * t) * (2 * kDamping / kOmega * std::cos(damped * t) +
                                               (2 * kDamping * kDamping - 1) / damped * std::sin(damped * t));
}
double firstOrderRamp(double t) {
    return t <= 0 ? 0 : t - kLag * (1 - std::exp(-t / kLag));
}

// A step with a straight flank is the difference of two ramps.
double flank(double (*ramp)(double), double t) {
    return (ramp(t - kOnset) - ramp(t - kOnset - kRamp)) / kRamp;
}
double steering(double t) {
    return std::clamp((t - kOnset) / kRamp, 0.0, 1.0);
}
double yaw(double t) {
    return flank(secondOrderRamp, t);
}
double lateral(double t) {
    return flank(firstOrderRamp, t);
}

Log stepLog(double rate, double sign = 1, double duration = 6) {
    const double angle = sign * kAngle;
    return log(rate, duration,
               {{"driver.steering_wheel_angle", "rad", [=](double t) { return 0.01 + angle * steering(t); }},
                {"chassis.vx", "m/s", constant(22)},
                {"chassis.yaw_rate", "rad/s", [=](double t) { return 0.002 + angle * kYawGain * yaw(t); }},
                {"chassis.ay", "m/s2", [=](double t) { return -0.05 + angle * kAyGain * lateral(t); }},
                {"chassis.sideslip", "rad", [=](double t) { return angle / kAngle * kSlip * lateral(t); }},
                {"chassis.roll", "rad", [=](double t) { return 0.001 + angle * kAyGain * kRollGain * lateral(t); }}});
}

// The truth, from the closed forms: bisection for the time, a fine scan for the peak.
double timeOf(double (*answer)(double), double level) {
    double low = kOnset, high = kOnset;
    while (answer(high) < level) high += 1e-3;
    for (int i = 0; i < 60; ++i) (answer(0.5 * (low + high)) < level ? low : high) = 0.5 * (low + high);
    return low - kOnset - 0.5 * kRamp;
}
double peakTime() {
    static const double best = [] {
        double found = kOnset;
        for (double t = kOnset; t < kOnset + 3; t += 1e-5) found = yaw(t) > yaw(found) ? t : found;
        return found;
    }();
    return best - kOnset - 0.5 * kRamp;
}

// Straight lines between samples miss a curve by h^2 / 8 of its second derivative (at most omega^2 for both answers,
// 1 / lag^2 = 25); over a slope of at least 1.2 /s where 90 % is crossed that is a time.
double timeTolerance(double rate) {
    return kOmega * kOmega / 8 / 1.2 / (rate * rate) + 2e-5;
}

TEST(StepSteer, ResponsesOfClosedFormsAreFoundToInterpolationError) {
    for (const double rate : kRates) {
        for (const double sign : {1.0, -1.0}) {
            const auto found = metrics(stepLog(rate, sign), "step_steer");
            EXPECT_NEAR(valueOf(found, "yaw_rate_response_time"), timeOf(yaw, 0.9), timeTolerance(rate)) << rate;
            EXPECT_NEAR(valueOf(found, "ay_response_time"), timeOf(lateral, 0.9), timeTolerance(rate)) << rate;
            EXPECT_NEAR(valueOf(found, "yaw_rate_peak_response_time"), peakTime(), 2 / (rate * rate) + 2e-5) << rate;
            EXPECT_NEAR(valueOf(found, "yaw_rate_overshoot"), yaw(kOnset + 0.5 * kRamp + peakTime()) - 1, 1e-4) << rate;
            EXPECT_NEAR(valueOf(found, "yaw_rate_gain"), kYawGain, 1e-5);
            EXPECT_NEAR(valueOf(found, "ay_gain"), kAyGain, 1e-5);
            EXPECT_NEAR(valueOf(found, "steady_ay"), sign * kAngle * kAyGain, 1e-5);
            EXPECT_NEAR(valueOf(found, "steering_amplitude"), sign * kAngle / kDegree, 1e-5);
            EXPECT_NEAR(valueOf(found, "speed"), 22, 1e-12);
            EXPECT_NEAR(valueOf(found, "steady_sideslip"), kSlip / kDegree, 1e-5) << "as in a left turn";
            EXPECT_NEAR(valueOf(found, "tb"), peakTime() * kSlip / kDegree, 1e-3);
            EXPECT_NEAR(valueOf(found, "roll_gradient"), kRollGain / kDegree * kGravity, 1e-5);
            EXPECT_EQ(valueOf(found, "steady"), 1);
        }
    }
}

TEST(StepSteer, TheSteeringRateIsThatOfTheFlank) {
    EXPECT_NEAR(valueOf(metrics(stepLog(1000), "step_steer"), "steering_rate"), kAngle / kRamp / kDegree, 0.1);
    EXPECT_NEAR(valueOf(metrics(stepLog(50, -1), "step_steer"), "steering_rate"), kAngle / kRamp / kDegree, 1);
}

TEST(StepSteer, AnAnswerWithoutOvershootHasNoPeakTime) {
    const auto found = metrics(stepLog(100), "step_steer");
    EXPECT_NEAR(valueOf(found, "ay_overshoot"), 0, 1e-4);
    EXPECT_TRUE(std::isnan(valueOf(found, "ay_peak_response_time")));
}

TEST(StepSteer, AHoldThatReturnsIsEvaluatedUpToTheReturn) {
    Log log = stepLog(100, 1, 12);
    for (std::size_t i = 0; i < log.samples(); ++i) {
        if (log.channels[0].values[i] < 6) continue;
        for (std::size_t c : {1, 3, 4}) log.channels[c].values[i] = 0;
    }
    const auto found = metrics(log, "step_steer");
    EXPECT_NEAR(valueOf(found, "yaw_rate_gain"), kYawGain, 0.002);
    EXPECT_NEAR(valueOf(found, "yaw_rate_response_time"), timeOf(yaw, 0.9), 1e-3);
}

TEST(StepSteer, TheHoldEndsWhereTheDriverLiftsOffOrBrakes) {
    for (const char* pedal : {"driver.throttle", "driver.brake"}) {
        const bool lifts = pedal[7] == 't';
        Log log = stepLog(100, 1, 12);
        log.channels.push_back({pedal, "-", {}});
        for (std::size_t i = 0; i < log.samples(); ++i) {
            const bool late = log.channels[0].values[i] > 7;
            log.channels.back().values.push_back(late != lifts ? 0.3 : 0.0);
            if (log.channels[0].values[i] > 7.05) channel(log, "chassis.yaw_rate").values[i] *= 2;
        }
        EXPECT_NEAR(valueOf(metrics(log, "step_steer"), "yaw_rate_gain"), kYawGain, 1e-5) << pedal;
    }
}

TEST(StepSteer, ACarThatStillChangesAtTheEndIsNotSteady) {
    Log log = stepLog(100);
    Channel& yaw_rate = channel(log, "chassis.yaw_rate");
    for (std::size_t i = 0; i < log.samples(); ++i) yaw_rate.values[i] *= 1 + 0.1 * log.channels[0].values[i];
    const auto found = metrics(log, "step_steer");
    EXPECT_EQ(valueOf(found, "steady"), 0);
    // The last second, about 1 + 0.1 * 5.5.
    EXPECT_NEAR(valueOf(found, "steady_drift"), 0.1 / 1.55, 0.002);
}

// The noise of a good measured car: gyro 0.0016 rad/s, acceleration 0.036 m/s2.
TEST(StepSteer, MeasurementNoiseMovesTheMetricsLittle) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Log log = stepLog(100);
        addNoise(log, "chassis.yaw_rate", 0.0016, seed);
        addNoise(log, "chassis.ay", 0.036, seed + 100);
        addNoise(log, "driver.steering_wheel_angle", 0.002, seed + 200);
        addNoise(log, "chassis.vx", 0.03, seed + 300);
        const auto found = metrics(log, "step_steer");
        EXPECT_NEAR(valueOf(found, "yaw_rate_response_time"), timeOf(yaw, 0.9), 0.005) << seed;
        EXPECT_NEAR(valueOf(found, "ay_response_time"), timeOf(lateral, 0.9), 0.02) << seed;
        EXPECT_NEAR(valueOf(found, "yaw_rate_peak_response_time"), peakTime(), 0.04) << seed;
        EXPECT_NEAR(valueOf(found, "yaw_rate_overshoot"), 0.1255, 0.01) << seed;
        EXPECT_NEAR(valueOf(found, "yaw_rate_gain"), kYawGain, 0.002) << seed;
        EXPECT_NEAR(valueOf(found, "roll_gradient"), kRollGain / kDegree * kGravity, 0.02) << seed;
    }
}

TEST(StepSteer, WhatIsNoStepIsRefusedWithTheReason) {
    Log log = stepLog(100);
    for (double& angle : channel(log, "driver.steering_wheel_angle").values) angle = 0.01;
    EXPECT_EQ(errorOf(log, "step_steer"),
              "no step_steer in this log: the steering wheel moves by only 0 deg, expected a step of at least 1.1 deg");
    Log ramp = stepLog(100);
    for (std::size_t i = 0; i < ramp.samples(); ++i) ramp.channels[1].values[i] = 0.1 * ramp.channels[0].values[i];
    EXPECT_NE(errorOf(ramp, "step_steer").find("from 10 to 90 %"), std::string::npos) << errorOf(ramp, "step_steer");
    Log pulse = stepLog(100);
    for (std::size_t i = 160; i < pulse.samples(); ++i) pulse.channels[1].values[i] = 0.01;
    EXPECT_NE(errorOf(pulse, "step_steer").find("is held for"), std::string::npos) << errorOf(pulse, "step_steer");
    Log standing = stepLog(100);
    for (double& v : channel(standing, "chassis.vx").values) v = 0;
    EXPECT_NE(errorOf(standing, "step_steer").find("the car moves at"), std::string::npos);
}

TEST(StepSteer, MissingChannelsAreNamedTogether) {
    Log log = stepLog(100);
    remove(log, "chassis.ay");
    remove(log, "chassis.yaw_rate");
    EXPECT_EQ(errorOf(log, "step_steer"),
              "no step_steer in this log: it needs chassis.yaw_rate, chassis.ay, which the log does not have");
    Log broken = stepLog(100);
    channel(broken, "chassis.ay").values[50] = std::nan("");
    EXPECT_EQ(errorOf(broken, "step_steer"),
              "no step_steer in this log: it needs chassis.ay, which is not finite at t = 0.5 s");
}

TEST(StepSteer, WithoutSideslipAndRollTheirMetricsAreUndefined) {
    Log log = stepLog(100);
    remove(log, "chassis.roll");
    remove(log, "chassis.sideslip");
    const auto found = metrics(log, "step_steer");
    EXPECT_TRUE(std::isnan(valueOf(found, "roll_gradient")));
    EXPECT_TRUE(std::isnan(valueOf(found, "tb")));
    log.channels.push_back({"chassis.vy", "m/s", std::vector<double>(log.samples(), 0)});
    for (std::size_t i = 0; i < log.samples(); ++i) {
        log.channels.back().values[i] = 22 * std::tan(kSlip * lateral(log.channels[0].values[i]));
    }
    EXPECT_NEAR(valueOf(metrics(log, "step_steer"), "steady_sideslip"), kSlip / kDegree, 1e-5)
        << "from the velocity when the angle is not logged";
}

}  // namespace
}  // namespace tread::metrics_step_steer_test
