// Slowly increasing steer, weave and transition.

#include <gtest/gtest.h>

#include <cmath>

#include "shared/linear_single_track.h"
#include "unit/metrics_sample.h"

namespace tread::metrics_slow_steer_test {
namespace {

using sample::errorOf;
using sample::kDegree;
using sample::kGravity;
using sample::kRates;
using sample::valueOf;

constexpr double kTurn = 2 * 3.14159265358979323846;

// A car that answers at once, with ay = G (delta - delta0): A is 0.3 g / G + delta0.
TEST(SlowlyIncreasingSteer, AngleAtThreeTenthsOfAGIsOnTheLine) {
    constexpr double kGain = 6, kOffset = 0.03, kRate = 13.5 * kDegree, kZero = 0.05, kRatio = 15, kWheelbase = 2.6;
    for (const double rate : kRates) {
        for (const double sign : {1.0, -1.0}) {
            const auto hand = [=](double t) { return kZero + sign * (t < 1 ? 0 : kRate * (t - 1)); };
            const auto ay = [=](double t) {
                return sign * 8 * std::tanh(kGain / 8 * std::max(0.0, sign * (hand(t) - kZero) - kOffset));
            };
            const Log log = sample::log(rate, 15,
                                        {{"driver.steering_wheel_angle", "rad", hand},
                                         {"chassis.vx", "m/s", sample::constant(22)},
                                         {"chassis.ay", "m/s2", ay}});
            const auto found = metrics(log, "slowly_increasing_steer", {kWheelbase, kRatio});
            // The curve bends: up to 0.375 g, atanh(x)/x departs from 1 by x^2/3 = 7 %, whose mean slope the line
            // takes.
            const double expected = kOffset + 8 / kGain * std::atanh(0.3 * kGravity / 8);
            EXPECT_NEAR(valueOf(found, "steering_angle_03g"), expected / kDegree, 0.005 * expected / kDegree) << rate;
            EXPECT_NEAR(valueOf(found, "steering_rate"), 13.5, 0.01);
            EXPECT_NEAR(valueOf(found, "speed"), 22, 1e-9);
            const double slope = valueOf(found, "steering_wheel_gradient");
            EXPECT_NEAR(valueOf(found, "understeer_gradient"),
                        slope / kRatio - kWheelbase / (22 * 22) * kGravity / kDegree, 1e-6);
            const auto angle = [](double g) { return 8 / kGain * std::atanh(g * kGravity / 8) / kDegree; };
            const double secant = (angle(0.375) - angle(0.1)) / 0.275;
            EXPECT_NEAR(slope, secant, 0.02 * secant) << "of the curve over the range of the regression";
            EXPECT_NEAR(valueOf(found, "largest_ay"), std::abs(ay(15)), 1e-3);
        }
    }
}

TEST(SlowlyIncreasingSteer, UndersteerIsThatOfTheSingleTrackModel) {
    const shared::SingleTrack car;
    const auto hand = [](double t) { return t < 1 ? 0 : 13.5 * kDegree * (t - 1); };
    const auto found = metrics(car.drive(hand, 6, 100), "slowly_increasing_steer", {car.wheelbase(), car.ratio});
    EXPECT_NEAR(valueOf(found, "understeer_gradient"), car.understeer() * kGravity / kDegree,
                0.01 * car.understeer() * kGravity / kDegree);
    EXPECT_NE(errorOf(car.drive([](double t) { return t < 1 ? 0 : 2 * (t - 1); }, 4, 100), "slowly_increasing_steer")
                  .find("expected up to"),
              std::string::npos);
}

// A ratio that falls with the angle: the road wheels turn as h / (r0 - k h). A car whose lateral acceleration is in
// proportion to the road wheels has the gradient of a straight line; by one ratio it would not.
TEST(SlowlyIncreasingSteer, ARatioOverTheAngleIsTakenWhereTheWheelStands) {
    constexpr double kGain = 40, kSpeed = 22, kWheelbase = 2.6;  // m/s2 per rad of the road wheels
    const Curve ratio{{{0, 18}, {2, 12}}};
    const auto hand = [](double t) { return t < 1 ? 0 : 13.5 * kDegree * (t - 1); };
    const auto ay = [&](double t) { return kGain * hand(t) / ratio(hand(t)); };
    const Log log = sample::log(100, 7,
                                {{"driver.steering_wheel_angle", "rad", hand},
                                 {"chassis.vx", "m/s", sample::constant(kSpeed)},
                                 {"chassis.ay", "m/s2", ay}});
    const auto found = metrics(log, "slowly_increasing_steer", {.wheelbase = kWheelbase, .ratio_curve = ratio});
    const double expected = (1 / kGain - kWheelbase / (kSpeed * kSpeed)) * kGravity / kDegree;
    EXPECT_NEAR(valueOf(found, "understeer_gradient"), expected, 1e-3 * std::abs(expected));
}

// x = X sin(w t), y = Y sin(w t - phi): slope on centre Y/X cos(phi), branches 2 Y sin(phi) and 2 X sin(phi) apart.
TEST(Weave, LoopsOfSinesHaveTheirClosedForm) {
    constexpr double kX = 0.25, kY = 2, kR = 0.08, kM = 3, kAyPhase = 0.25, kYawPhase = 0.06, kTorquePhase = -0.4,
                     kF = 0.2;
    const auto wave = [](double amplitude, double phase, double offset = 0) {
        return [=](double t) { return offset + amplitude * std::sin(kTurn * kF * t - phase); };
    };
    for (const double rate : kRates) {
        const Log log = sample::log(rate, 25,
                                    {{"driver.steering_wheel_angle", "rad", wave(kX, 0, 0.01)},
                                     {"chassis.vx", "m/s", sample::constant(27.8)},
                                     {"chassis.yaw_rate", "rad/s", wave(kR, kYawPhase)},
                                     {"chassis.ay", "m/s2", wave(kY, kAyPhase, 0.05)},
                                     {"steering.torque", "N m", wave(kM, kTorquePhase)}});
        const auto found = metrics(log, "weave");
        const auto near = [&](const char* name, double expected) {
            // On centre are few samples at 50 Hz: where the branches bend, one more or less at an end is felt.
            EXPECT_NEAR(valueOf(found, name), expected, 0.01 * std::abs(expected)) << name << " at " << rate;
        };
        near("steering_sensitivity", kY / kX * std::cos(kAyPhase) / kGravity * 100 * kDegree);
        near("steering_hysteresis", 2 * kX * std::sin(kAyPhase) / kDegree);
        near("ay_hysteresis", 2 * kY * std::sin(kAyPhase));
        near("yaw_rate_gain", kR / kX * std::cos(kYawPhase));
        near("yaw_rate_lag", kYawPhase / (kTurn * kF));
        near("steering_stiffness", kM / kX * std::cos(kTorquePhase));
        near("steering_friction", 2 * kM * std::sin(-kTorquePhase));
        near("torque_gradient", kM / kY * std::cos(kTorquePhase - kAyPhase) * kGravity);
        near("torque_deadband", 2 * kY * std::sin(kAyPhase - kTorquePhase) / kGravity);
        near("frequency", kF);
        near("steering_amplitude", kX / kDegree);
        near("ay_amplitude", kY);
    }
}

TEST(Weave, WithoutTorqueItsMetricsAreUndefined) {
    const shared::SingleTrack car;
    const auto found = metrics(car.drive([](double t) { return 0.2 * std::sin(kTurn * 0.2 * t); }, 25, 50), "weave");
    EXPECT_TRUE(std::isnan(valueOf(found, "torque_gradient")));
    EXPECT_NEAR(valueOf(found, "yaw_rate_gain"), car.at(0.2).yaw_rate.real(), 0.01 * car.yawGain());
    EXPECT_NE(
        errorOf(car.drive([](double t) { return 0.2 * std::sin(kTurn * t); }, 25, 50), "weave").find("swings at 1 Hz"),
        std::string::npos);
}

TEST(Transition, SlopeAndDeadBandAreThoseOfTheLine) {
    constexpr double kGain = 8, kDead = 0.02, kRate = 2 * kDegree, kTorque = 2.5, kFriction = 0.7;
    for (const double rate : kRates) {
        for (const double sign : {1.0, -1.0}) {
            const auto hand = [=](double t) { return sign * (t < 1 ? 0 : kRate * (t - 1)); };
            const auto ay = [=](double t) { return sign * kGain * std::max(0.0, std::abs(hand(t)) - kDead); };
            const Log log =
                sample::log(rate, 8,
                            {{"driver.steering_wheel_angle", "rad", hand},
                             {"chassis.vx", "m/s", sample::constant(27.8)},
                             {"chassis.yaw_rate", "rad/s", [=](double t) { return ay(t) / 27.8; }},
                             {"chassis.ay", "m/s2", ay},
                             {"steering.torque", "N m", [=](double t) { return sign * kFriction + kTorque * ay(t); }}});
            const auto found = metrics(log, "transition");
            EXPECT_NEAR(valueOf(found, "steering_sensitivity"), kGain / kGravity * 100 * kDegree, 1e-3) << rate;
            EXPECT_NEAR(valueOf(found, "steering_deadband"), kDead / kDegree, 0.01) << rate;
            EXPECT_NEAR(valueOf(found, "yaw_rate_gain"), kGain / 27.8, 1e-4) << rate;
            EXPECT_NEAR(valueOf(found, "torque_gradient"), kTorque * kGravity, 1e-3) << rate;
            EXPECT_NEAR(valueOf(found, "torque_deadband"), kFriction, 1e-3) << rate;
            EXPECT_NEAR(valueOf(found, "steering_rate"), 2, 0.01);
        }
    }
}

}  // namespace
}  // namespace tread::metrics_slow_steer_test
