#include "tread/steering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tread::steering_test {
namespace {

constexpr double kTrack = 1.5, kWheelbase = 2.6;

TEST(Steering, WithoutAckermannBothWheelsTurnByTheSteeringWheelOverTheRatio) {
    const SteeringParams p{.ratio = 16, .ackermann = 0};
    for (const double hand : {-4.0, 0.0, 1.6}) {
        const RoadWheelAngles wheels = roadWheelAngles(p, hand, kTrack, kWheelbase);
        EXPECT_EQ(wheels.left, hand / 16);
        EXPECT_EQ(wheels.right, hand / 16);
    }
}

TEST(Steering, FullAckermannPointsBothAxlesAtOneCentre) {
    const SteeringParams p{.ratio = 16, .ackermann = 1};
    for (const double hand : {-7.0, -0.5, 0.5, 3.0, 7.0}) {
        const RoadWheelAngles wheels = roadWheelAngles(p, hand, kTrack, kWheelbase);
        // The normal of each wheel meets the rear axle's line at the same distance to the left.
        const double from_left = kWheelbase / std::tan(wheels.left) + 0.5 * kTrack;
        const double from_right = kWheelbase / std::tan(wheels.right) - 0.5 * kTrack;
        EXPECT_NEAR(from_left, from_right, 1e-9);
        EXPECT_NEAR(from_left, kWheelbase / std::tan(hand / 16), 1e-9);
        EXPECT_GT(std::abs(hand > 0 ? wheels.left : wheels.right), std::abs(hand > 0 ? wheels.right : wheels.left))
            << "the inner wheel turns more";
    }
}

TEST(Steering, LeftAndRightMirrorEachOther) {
    const SteeringParams p{.ratio = 15, .ackermann = 0.6};
    const RoadWheelAngles left = roadWheelAngles(p, 2, kTrack, kWheelbase);
    const RoadWheelAngles right = roadWheelAngles(p, -2, kTrack, kWheelbase);
    EXPECT_DOUBLE_EQ(left.left, -right.right);
    EXPECT_DOUBLE_EQ(left.right, -right.left);
}

TEST(Steering, NoAngleAtTheCentreForAnyAckermann) {
    for (const double ackermann : {-0.5, 0.0, 0.5, 1.0}) {
        const RoadWheelAngles wheels = roadWheelAngles({.ratio = 15, .ackermann = ackermann}, 0, kTrack, kWheelbase);
        EXPECT_EQ(wheels.left, 0);
        EXPECT_EQ(wheels.right, 0);
    }
}

// ---- Ratio curve ----

SteeringParams progressive() {
    return {.ratio = 16, .ratio_curve = {{{0, 18}, {1, 16}, {6, 13}}}};
}

TEST(Steering, RatioCurveIsSteeringWheelOverRoadWheelAngleToBothSides) {
    const SteeringParams p = progressive();
    for (const auto& [hand, ratio] : {std::pair{0.5, 17.0}, {1.0, 16.0}, {3.5, 14.5}, {8.0, 13.0}}) {
        EXPECT_NEAR(roadWheelAngles(p, hand, kTrack, kWheelbase).left, hand / ratio, 1e-12);
        EXPECT_NEAR(roadWheelAngles(p, -hand, kTrack, kWheelbase).left, -hand / ratio, 1e-12);
    }
}

// ---- From the driver's angle to the wheels ----

constexpr double kStep = 0.001;  // s

// Steering-wheel angles over time for a driver's angle, without forces.
template <class Driver>
std::vector<RoadWheelAngles> followed(const SteeringParams& p, Driver driver, double duration, double dt = kStep) {
    SteeringState state = steadySteering(p, driver(0.0), kTrack, kWheelbase);
    std::vector<RoadWheelAngles> wheels;
    for (long k = 1; k <= std::lround(duration / dt); ++k) {
        const double t = static_cast<double>(k) * dt;
        wheels.push_back(advance(state, p, {driver(t - dt), driver(t), false, kTrack, kWheelbase, 0, 0, 0, 0}, dt).end);
    }
    return wheels;
}

TEST(Steering, LagFollowsAStepWithItsTimeConstant) {
    const SteeringParams p{.ratio = 1, .lag = 0.08};
    for (const double dt : {0.001, 0.01}) {
        const auto wheels = followed(
            p, [](double t) { return t > 0 ? 1.0 : 0.0; }, 0.3, dt);
        for (std::size_t k = 0; k < wheels.size(); ++k) {
            const double t = static_cast<double>(k + 1) * dt;
            // The step rises over the first time step.
            const double exact = 1 - 0.08 / dt * (std::exp(dt / 0.08) - 1) * std::exp(-t / 0.08);
            EXPECT_NEAR(wheels[k].left, exact, 1e-12) << "exact for any step";
        }
    }
}

TEST(Steering, DelayShiftsEverySignalByItsTime) {
    const auto driver = [](double t) { return t < 0 ? 0.0 : std::sin(9 * t) + 0.2 * t; };
    for (const double delay : {0.2, 0.05, 0.0137, 0.001, 1e-4, 1e-9}) {
        for (const double dt : {0.001, 0.0004, 0.0025}) {
            const auto wheels = followed({.ratio = 1, .delay = delay}, driver, 1.0, dt);
            double largest = 0;
            for (std::size_t k = 0; k < wheels.size(); ++k) {
                const double t = static_cast<double>(k + 1) * dt;
                largest = std::max(largest, std::abs(wheels[k].left - driver(t - delay)));
            }
            // Linear between points: an eighth of curvature times distance squared, of the driver's steps and of the
            // line's.
            const double point = delay / 200;
            EXPECT_LT(largest, 81 * (dt * dt + point * point) / 8 + 1e-9) << delay << ", " << dt;
        }
    }
}

TEST(Steering, DelayAndLagAddUp) {
    // A ramp comes later by both, whatever shares they have.
    const auto wheels = followed(
        {.ratio = 1, .delay = 0.03, .lag = 0.02}, [](double t) { return 2 * t; }, 0.5);
    EXPECT_NEAR(wheels.back().left, 2 * (0.5 - 0.05), 1e-9);
}

TEST(Steering, PlayLeavesTheWheelsAtTheCentreAndThenFollowsBehind) {
    const SteeringParams p{.ratio = 10, .play = 0.1};
    const auto wheels = followed(
        p, [](double t) { return 0.2 * std::sin(t); }, 6.28);
    for (std::size_t k = 0; k < wheels.size(); ++k) {
        const double hand = 0.2 * std::sin(static_cast<double>(k + 1) * kStep);
        const double expected = std::abs(hand) < 0.05 ? 0 : (hand - std::copysign(0.05, hand)) / 10;
        EXPECT_NEAR(wheels[k].left, expected, 1e-12);
    }
}

TEST(Steering, ComplianceTurnsTheWheelsByTheirMomentAtTheColumnOverTheRatioSquared) {
    const SteeringParams p{.ratio = 15, .column_compliance = 0.009, .rack_compliance = 2e-5};
    SteeringState state = steadySteering(p, 0.3, kTrack, kWheelbase);
    RoadWheelAngles wheels;
    for (int k = 0; k < 200; ++k)
        wheels = advance(state, p, {0.3, 0.3, false, kTrack, kWheelbase, -60, -40, 5000, 0}, kStep).end;
    EXPECT_NEAR(wheels.left, 0.3 / 15 - 100 * (2e-5 + 0.009 / 225), 1e-12);
    EXPECT_NEAR(steeringWheelTorque(state, p, -60, -40), 100 / 15.0, 1e-9) << "holding against the wheels, to the left";
}

// ---- Torque and hands off ----

TEST(Steering, TorqueAtTheSteeringWheelDoesTheWorkOfTheWheels) {
    // Virtual work: torque times the steering wheel's turn is the moments times the wheels' turns.
    SteeringParams p = progressive();
    p.ackermann = 0.8;
    const double left_moment = -70, right_moment = 30, small = 1e-6;
    for (const double hand : {-5.0, -0.4, 0.0, 0.7, 3.0, 6.5}) {
        const SteeringState state = steadySteering(p, hand, kTrack, kWheelbase);
        const RoadWheelAngles more = roadWheelAngles(p, hand + small, kTrack, kWheelbase);
        const RoadWheelAngles less = roadWheelAngles(p, hand - small, kTrack, kWheelbase);
        const double work =
            (left_moment * (more.left - less.left) + right_moment * (more.right - less.right)) / (2 * small);
        EXPECT_NEAR(steeringWheelTorque(state, p, left_moment, right_moment), -work, 1e-6) << hand;
    }
}

TEST(Steering, DampingAndFrictionOpposeTheDriver) {
    const SteeringParams p{.ratio = 16, .damping = 0.5, .friction = 2};
    SteeringState state = steadySteering(p, 0, kTrack, kWheelbase);
    advance(state, p, {0, 0.003, false, kTrack, kWheelbase, 0, 0, 0, 0}, kStep);
    EXPECT_NEAR(steeringWheelTorque(state, p, 0, 0), 0.5 * 3 + 2, 1e-9)
        << "turning to the left takes torque to the left";
    advance(state, p, {0.003, 0.003, false, kTrack, kWheelbase, 0, 0, 0, 0}, kStep);
    EXPECT_EQ(steeringWheelTorque(state, p, 0, 0), 0);
}

TEST(Steering, MomentsAboutTheAxisHaveTheSignsOfTrailAndScrub) {
    const SteeringParams p{.ratio = 16, .caster_trail = 0.03, .scrub_radius = 0.01};
    EXPECT_NEAR(steeringMoment(p, 0, 1000, 0, true), -30, 1e-12) << "a force to the left behind the axis turns right";
    EXPECT_NEAR(steeringMoment(p, 1000, 0, 0, true), -10, 1e-12) << "driving toes the left wheel in";
    EXPECT_NEAR(steeringMoment(p, 1000, 0, 0, false), 10, 1e-12);
    EXPECT_EQ(steeringMoment(p, 0, 0, 5, false), 5);
}

// The wheels as a spring about the steering axes.
template <class Each>
void letGo(const SteeringParams& p, double stiffness, double from, double duration, Each each) {
    SteeringState state = steadySteering(p, from, kTrack, kWheelbase);
    advance(state, p, {from, from, false, kTrack, kWheelbase, -stiffness * from / p.ratio, 0, 0, 0}, kStep);
    for (double t = 0; t < duration; t += kStep) {
        const double moment = -stiffness * state.wheels.angles.left;
        advance(state, p, {from, from, true, kTrack, kWheelbase, moment, 0, 0, 0}, kStep);
        each(t + kStep, state.angle);
    }
}

TEST(Steering, HandsOffSwingsWithItsInertiaAgainstTheMomentOfTheWheels) {
    const SteeringParams p{.ratio = 16, .inertia = 0.05};
    const double stiffness = 5000, frequency = std::sqrt(stiffness / 256 / 0.05);  // rad/s
    letGo(p, stiffness, 0.5, 2,
          [&](double t, double angle) { EXPECT_NEAR(angle, 0.5 * std::cos(frequency * t), 0.005) << t; });
}

TEST(Steering, HandsOffDampingDecaysAsCalculated) {
    const SteeringParams p{.ratio = 16, .inertia = 0.05, .damping = 0.4};
    const double stiffness = 5000, decay = 0.4 / (2 * 0.05);
    const double frequency = std::sqrt(stiffness / 256 / 0.05 - decay * decay);
    letGo(p, stiffness, 0.5, 1, [&](double t, double angle) {
        const double exact =
            0.5 * std::exp(-decay * t) * (std::cos(frequency * t) + decay / frequency * std::sin(frequency * t));
        EXPECT_NEAR(angle, exact, 0.005) << t;
    });
}

TEST(Steering, HandsOffFrictionHoldsTheWheelWhenItCan) {
    const SteeringParams p{.ratio = 16, .inertia = 0.05, .friction = 2};
    letGo(p, 5000, 0.1, 0.5, [](double, double angle) { EXPECT_EQ(angle, 0.1); });
    // Each half swing ends nearer to the centre by twice the angle that friction holds.
    const double held = 2 / (5000.0 / 256);
    double lowest = 1;
    letGo(p, 5000, 0.5, 0.4, [&](double, double angle) { lowest = std::min(lowest, angle); });
    EXPECT_NEAR(lowest, -(0.5 - 2 * held), 0.003);
}

TEST(Steering, HandsThatComeBackTakeTheWheelWhereItIs) {
    const SteeringParams p{.ratio = 16, .inertia = 0.05};
    SteeringState state = steadySteering(p, 0, kTrack, kWheelbase);
    for (int k = 0; k < 100; ++k) advance(state, p, {0, 0, true, kTrack, kWheelbase, 10, 10, 0, 0}, kStep);
    const double angle = state.angle;
    EXPECT_GT(angle, 0.01);
    const SteeringMotion motion = advance(state, p, {angle, angle, false, kTrack, kWheelbase, 10, 10, 0, 0}, kStep);
    EXPECT_NEAR(motion.begin.left, motion.end.left, 1e-15);
    EXPECT_EQ(state.angle, angle);
}

}  // namespace
}  // namespace tread::steering_test
