// The other car simulator (tests/shared/other_car), against closed forms: it is to be independent of tread, so it needs
// checks of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "shared/other_car/car.h"
#include "shared/other_car/compact.h"

namespace other_car {
namespace {

constexpr double kStep = 0.001;  // s

Car driven(const Params& params, double speed, double seconds, const std::function<Input(double)>& input) {
    Car car(params, speed);
    for (int i = 0; i < static_cast<int>(seconds / kStep); ++i)
        car.step(input(i * kStep), input((i + 1) * kStep), kStep);
    return car;
}

// Cornering stiffness of an axle at its static load.
double axleStiffness(const Params& p, bool front) {
    const Tyre& tyre = front ? p.front.tyre : p.rear.tyre;
    const double arm = front ? p.wheelbase - p.front_distance : p.front_distance;
    const double x = p.mass * kGravity * arm / p.wheelbase / 2 / tyre.stiffness_load;
    return 2 * tyre.stiffness * 2 * x / (1 + x * x);  // sin(2 arctan x)
}

Params simple() {
    Params p = compact();
    for (Axle* axle : {&p.front, &p.rear}) {
        axle->unsprung_mass = 0;
        axle->compliance_steer = axle->toe_by_travel = axle->lift_area = 0;
        axle->tyre.rolling_resistance = axle->tyre.camber_stiffness = axle->tyre.trail = 0;
    }
    p.drag_area = p.side_area = p.yaw_volume = p.drag_scale = 0;
    return p;
}

TEST(OtherCar, YawGainIsThatOfTheSingleTrackModel) {
    const Params p = simple();
    constexpr double kSpeed = 20, kHand = 0.05;
    const Car car = driven(p, kSpeed, 4, [](double) { return Input{.hand_wheel = kHand}; });
    const double rear = p.wheelbase - p.front_distance;
    const double understeer =
        p.mass / p.wheelbase * (rear / axleStiffness(p, true) - p.front_distance / axleStiffness(p, false));
    const double v = car.state()[kVx];
    const double gain = v / (p.wheelbase + understeer * v * v) / p.steering_ratio;
    EXPECT_NEAR(car.state()[kYawRate] / kHand, gain, 0.01 * gain);
}

TEST(OtherCar, RollAngleIsMomentOverStiffness) {
    const Params p = simple();
    const Car car = driven(p, 20, 4, [](double) { return Input{.hand_wheel = 0.3}; });
    const double axis =
        (p.front.roll_axis * (p.wheelbase - p.front_distance) + p.rear.roll_axis * p.front_distance) / p.wheelbase;
    const double arm = p.height - axis, ay = car.forces({.hand_wheel = 0.3}).ay;
    const double stiffness = p.front.rollStiffness() + p.rear.rollStiffness() - p.mass * kGravity * arm;
    EXPECT_GT(ay, 2);
    EXPECT_NEAR(car.state()[kRoll], p.mass * ay * arm / stiffness, 0.01 * p.mass * ay * arm / stiffness);
}

TEST(OtherCar, HeldStraightOnABankItLeansToTheLowSide) {
    Params p = simple();
    p.bank = 0.02;
    Car car(p, 20);
    for (int i = 0; i < 6000; ++i) {
        const Input held{.hand_wheel = -10 * car.state()[kYaw] - 5 * car.state()[kYawRate]};
        car.step(held, held, kStep);
    }
    EXPECT_NEAR(car.state()[kYawRate], 0, 2e-4);
    const double axis =
        (p.front.roll_axis * (p.wheelbase - p.front_distance) + p.rear.roll_axis * p.front_distance) / p.wheelbase;
    const double moment = p.mass * kGravity * p.bank * (p.height - axis);
    const double stiffness = p.front.rollStiffness() + p.rear.rollStiffness() - p.mass * kGravity * (p.height - axis);
    EXPECT_NEAR(car.roll(), p.bank + moment / stiffness, 0.01 * p.bank);
}

TEST(OtherCar, LoadsCarryTheCarAndMoveOutwards) {
    const Params p = simple();
    const Car car = driven(p, 20, 4, [](double) { return Input{.hand_wheel = 0.5}; });
    const Forces f = car.forces({.hand_wheel = 0.5});
    EXPECT_NEAR(f.load[0] + f.load[1] + f.load[2] + f.load[3], p.mass * kGravity, 1e-6 * p.mass * kGravity);
    // Moments about the ground line: what the outer wheels have more holds the height of the centre of gravity.
    const double shift = 0.5 * (p.front.track * (f.load[1] - f.load[0]) + p.rear.track * (f.load[3] - f.load[2]));
    const double roll_moment = p.mass * f.ay * p.height + p.mass * kGravity * car.state()[kRoll] * (p.height - 0.08);
    EXPECT_NEAR(shift, roll_moment, 0.03 * roll_moment);
}

TEST(OtherCar, BrakesDecelerateTheMassAndTheWheels) {
    const Params p = simple();
    constexpr double kPedal = 0.2;
    const Car car = driven(p, 30, 1, [](double) { return Input{.brake = kPedal}; });
    const double front = 2 * p.front.wheel_inertia + p.engine_inertia * p.drive_ratio * p.drive_ratio;
    const auto mass = [](double inertia, const Tyre& t) { return inertia / (t.rolling_radius * t.loaded_radius); };
    const double wheels = mass(front, p.front.tyre) + mass(2 * p.rear.wheel_inertia, p.rear.tyre);
    const double force =
        kPedal * p.brake_torque *
        (p.brake_front_share / p.front.tyre.loaded_radius + (1 - p.brake_front_share) / p.rear.tyre.loaded_radius);
    const double expected = force / (p.mass + wheels);
    EXPECT_NEAR(-car.forces({.brake = kPedal}).ax, expected, 0.01 * expected);
}

TEST(OtherCar, BrakingPitchesTheNoseDownAndLoadsTheFront) {
    const Params p = simple();
    const Car car = driven(p, 30, 2, [](double) { return Input{.brake = 0.2}; });
    const Forces f = car.forces({.brake = 0.2});
    EXPECT_GT(car.state()[kPitch], 0.005);
    const double front = p.mass * kGravity * (p.wheelbase - p.front_distance) / p.wheelbase;
    const double shift = -p.mass * f.ax * p.height / p.wheelbase;
    EXPECT_NEAR(f.load[0] + f.load[1] - front, shift, 0.01 * shift);
}

TEST(OtherCar, SideForceRelaxesOverItsLength) {
    // A front wheel that is turned at once has 63 % of its slip after one relaxation length.
    Params p = simple();
    p.yaw_inertia *= 1e6;
    constexpr double kSpeed = 20;
    Car car(p, kSpeed);
    const Input turned{.hand_wheel = 0.01};
    const double length = axleStiffness(p, true) / 2 / p.front.tyre.carcass, time = length / kSpeed;
    for (int i = 0; i < static_cast<int>(std::lround(time / 1e-4)); ++i) car.step(turned, turned, 1e-4);
    EXPECT_NEAR(car.state()[kAlpha], (1 - std::exp(-1)) * 0.01 / p.steering_ratio, 0.05 * 0.01 / p.steering_ratio);
}

TEST(OtherCar, TyreGivesItsFrictionAndNoMore) {
    const Tyre tyre = compact().front.tyre;
    double most = 0;
    for (int i = 0; i < 100; ++i) {
        const TyreForce f = force(tyre, tyre.nominal_load, 1, -0.003 * i, 0.004 * i, 0);
        most = std::max(most, std::hypot(f.fx, f.fy));
    }
    EXPECT_NEAR(most, tyre.friction * tyre.nominal_load, 0.01 * tyre.friction * tyre.nominal_load);
}

TEST(OtherCar, HalvingTheStepChangesNothing) {
    const Params p = compact();
    const Input turned{.hand_wheel = 0.6, .throttle = 0.3};
    Car coarse(p, 25), fine(p, 25);
    for (int i = 0; i < 1000; ++i) coarse.step(turned, turned, kStep);
    for (int i = 0; i < 2000; ++i) fine.step(turned, turned, kStep / 2);
    EXPECT_NEAR(coarse.state()[kYawRate], fine.state()[kYawRate], 1e-6);
    EXPECT_NEAR(coarse.state()[kRoll], fine.state()[kRoll], 1e-6);
}

}  // namespace
}  // namespace other_car
