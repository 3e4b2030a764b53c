#include <gtest/gtest.h>

#include <cmath>

#include "metrics_sample.h"

namespace tread::metrics_steady_circle_test {
namespace {

using namespace sample;

// Linear single-track car: delta = L / R + K ay, sideslip = b / R - F ay.
constexpr double kWheelbase = 2.7, kRear = 1.5, kRatio = 16;
constexpr double kUndersteer = 0.004;    // rad per m/s2
constexpr double kSlip = 0.006;          // rad per m/s2
constexpr double kFrontSlip = 0.010;     // rad per m/s2; the rear axle slips by the difference to the understeer
constexpr double kRollGradient = 0.008;  // rad per m/s2
constexpr double kPerG = kGravity / kDegree;

struct Turn {
    double ay, v;  // ay positive left
    double curvature() const { return ay / (v * v); }
};

Log circleLog(double rate, double duration, const std::function<Turn(double)>& turn) {
    const auto road = [=](double t) { return kWheelbase * turn(t).curvature() + kUndersteer * turn(t).ay; };
    std::vector<Signal> signals = {
        {"driver.steering_wheel_angle", "rad", [=](double t) { return kRatio * road(t); }},
        {"chassis.vx", "m/s", [=](double t) { return turn(t).v; }},
        {"chassis.yaw_rate", "rad/s", [=](double t) { return turn(t).ay / turn(t).v; }},
        {"chassis.ay", "m/s2", [=](double t) { return turn(t).ay; }},
        {"chassis.roll", "rad", [=](double t) { return kRollGradient * turn(t).ay; }},
        {"chassis.sideslip", "rad", [=](double t) { return kRear * turn(t).curvature() - kSlip * turn(t).ay; }}};
    for (const char* side : {"left", "right"}) {
        const double toe = side[0] == 'l' ? -0.002 : 0.002;  // cancels in the mean
        const std::string front = std::string("wheel.front_") + side, rear = std::string("wheel.rear_") + side;
        signals.push_back({front + ".steer", "rad", [=](double t) { return road(t) + toe; }});
        signals.push_back({rear + ".steer", "rad", constant(-toe)});
        // ISO 8855: in a left turn the wheels drift to the right, a negative slip angle.
        signals.push_back({front + ".slip_angle", "rad", [=](double t) { return -kFrontSlip * turn(t).ay; }});
        signals.push_back(
            {rear + ".slip_angle", "rad", [=](double t) { return -(kFrontSlip - kUndersteer) * turn(t).ay; }});
    }
    return log(rate, duration, signals);
}

// Constant radius of 100 m, the speed rising until 8 m/s2; constant speed of 80 km/h, the steering rising; constant
// steering-wheel angle, the speed rising.
Turn radius(double t) {
    const double ay = 0.05 + 7.95 * t / 60;
    return {ay, std::sqrt(100 * ay)};
}
Turn speed(double t) {
    return {8 * t / 60, 80 / 3.6};
}
Turn held(double t) {
    const double v = 3 + 0.25 * t, delta = 0.05;
    return {delta / (kWheelbase / (v * v) + kUndersteer), v};
}

TEST(SteadyCircle, TheConstantRadiusMethodGivesTheGradientsOfTheLinearCar) {
    for (const double rate : kRates) {
        for (const double sign : {1.0, -1.0}) {
            const auto found = metrics(circleLog(rate, 60,
                                                 [=](double t) {
                                                     return Turn{sign * radius(t).ay, radius(t).v};
                                                 }),
                                       "steady_circle");
            EXPECT_EQ(valueOf(found, "method"), 1);
            EXPECT_NEAR(valueOf(found, "understeer_gradient"), kUndersteer * kPerG, 1e-6);
            EXPECT_NEAR(valueOf(found, "steering_wheel_gradient"), kRatio * kUndersteer * kPerG, 1e-5);
            EXPECT_NEAR(valueOf(found, "roll_gradient"), kRollGradient * kPerG, 1e-6);
            EXPECT_NEAR(valueOf(found, "sideslip_gradient"), -kSlip * kPerG, 1e-6);
            EXPECT_NEAR(valueOf(found, "radius"), 100, 1e-6);
            EXPECT_NEAR(valueOf(found, "largest_ay"), 8, 1e-9);
        }
    }
}

TEST(SteadyCircle, AtConstantSpeedTheAckermannPartIsTakenOut) {
    const double v = 80 / 3.6;
    for (const double rate : kRates) {
        Log log = circleLog(rate, 60, speed);
        const auto from_slip = metrics(log, "steady_circle");
        EXPECT_EQ(valueOf(from_slip, "method"), 2);
        EXPECT_NEAR(valueOf(from_slip, "understeer_gradient"), kUndersteer * kPerG, 1e-6) << "from the slip angles";
        EXPECT_NEAR(valueOf(from_slip, "steering_wheel_gradient"),
                    kRatio * (kUndersteer + kWheelbase / (v * v)) * kPerG, 1e-5);
        for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"}) {
            remove(log, std::string("wheel.") + wheel + ".slip_angle");
            remove(log, std::string("wheel.") + wheel + ".steer");
        }
        EXPECT_TRUE(std::isnan(valueOf(metrics(log, "steady_circle"), "understeer_gradient")));
        EXPECT_NEAR(valueOf(metrics(log, "steady_circle", {kWheelbase, kRatio}), "understeer_gradient"),
                    kUndersteer * kPerG, 1e-6)
            << "from the known car";
    }
}

TEST(SteadyCircle, AtConstantSteeringTheGradientComesFromTheRadius) {
    const auto found = metrics(circleLog(100, 60, held), "steady_circle", {kWheelbase, kRatio});
    EXPECT_EQ(valueOf(found, "method"), 3);
    EXPECT_NEAR(valueOf(found, "understeer_gradient"), kUndersteer * kPerG, 1e-6);
}

// Left and right together cancel a steering offset and a biased accelerometer.
TEST(SteadyCircle, BothDirectionsCancelOffsets) {
    Log log = circleLog(100, 120, [](double t) {
        const Turn turn = radius(t <= 60 ? t : 120 - t);
        return Turn{t <= 60 ? turn.ay : -turn.ay, turn.v};
    });
    for (double& angle : channel(log, "driver.steering_wheel_angle").values) angle += 0.1;
    for (double& ay : channel(log, "chassis.ay").values) ay += 0.07;
    EXPECT_NEAR(valueOf(metrics(log, "steady_circle"), "steering_wheel_gradient"), kRatio * kUndersteer * kPerG, 1e-3);
}

TEST(SteadyCircle, MeasurementNoiseMovesTheMetricsLittle) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Log log = circleLog(100, 60, radius);
        addNoise(log, "chassis.ay", 0.06, seed);
        addNoise(log, "chassis.yaw_rate", 0.002, seed + 100);
        addNoise(log, "chassis.vx", 0.03, seed + 200);
        addNoise(log, "driver.steering_wheel_angle", 0.01, seed + 300);
        addNoise(log, "chassis.roll", 0.001, seed + 400);
        const auto found = metrics(log, "steady_circle");
        EXPECT_EQ(valueOf(found, "method"), 1);
        EXPECT_NEAR(valueOf(found, "understeer_gradient") / (kUndersteer * kPerG), 1, 0.01) << seed;
        EXPECT_NEAR(valueOf(found, "steering_wheel_gradient") / (kRatio * kUndersteer * kPerG), 1, 0.02) << seed;
        EXPECT_NEAR(valueOf(found, "roll_gradient") / (kRollGradient * kPerG), 1, 0.02) << seed;
    }
}

TEST(SteadyCircle, AQuickReleaseAtTheEndIsLeftOut) {
    Log log = circleLog(100, 61, [](double t) { return t < 60 ? speed(t) : Turn{8 * (61 - t), speed(t).v}; });
    for (std::size_t i = 6000; i < log.samples(); ++i) channel(log, "wheel.front_left.steer").values[i] += 0.05;
    EXPECT_NEAR(valueOf(metrics(log, "steady_circle", {kWheelbase, kRatio}), "understeer_gradient"),
                kUndersteer * kPerG, 1e-6);
}

TEST(SteadyCircle, WhatIsNoSteadyCircleIsRefusedWithTheReason) {
    const Log straight = circleLog(100, 60, [](double) { return Turn{0, 20}; });
    EXPECT_NE(errorOf(straight, "steady_circle").find("expected a turn"), std::string::npos);
    const Log quick = circleLog(100, 10, [](double t) { return Turn{5 * std::exp(-8 * (t - 5) * (t - 5)), 20}; });
    EXPECT_NE(errorOf(quick, "steady_circle").find("expected slow changes"), std::string::npos)
        << errorOf(quick, "steady_circle");
    const Log weave = circleLog(100, 60, [](double t) { return Turn{3 * std::sin(0.2 * 2 * 3.14 * t), 20}; });
    EXPECT_NE(errorOf(weave, "steady_circle").find("swings back and forth"), std::string::npos)
        << errorOf(weave, "steady_circle");
}

}  // namespace
}  // namespace tread::metrics_steady_circle_test
