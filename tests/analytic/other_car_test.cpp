// The other car simulator (tests/shared/other_car), against closed forms: it is to be independent of tread, so it needs
// checks of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "shared/other_car/car.h"
#include "shared/other_car/compact.h"

namespace other_car::other_car_test {
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
        axle->compliance_steer = axle->toe = axle->toe_by_travel = axle->camber = axle->lift_area = 0;
        axle->tyre.rolling_resistance = axle->tyre.camber_stiffness = axle->tyre.trail = 0;
    }
    p.drag_area = p.side_area = p.yaw_volume = p.drag_scale = 0;
    return p;
}

TEST(OtherCar, YawGainIsThatOfTheSingleTrackModel) {
    const Params p = simple();
    constexpr double kSpeed = 20, kHand = 0.05;
    const Car car = driven(p, kSpeed, 4, [](double) { return Input{.steering_wheel = kHand}; });
    const double rear = p.wheelbase - p.front_distance;
    const double understeer =
        p.mass / p.wheelbase * (rear / axleStiffness(p, true) - p.front_distance / axleStiffness(p, false));
    const double v = car.state()[kVx];
    const double gain = v / (p.wheelbase + understeer * v * v) / p.steering_ratio;
    EXPECT_NEAR(car.state()[kYawRate] / kHand, gain, 0.01 * gain);
}

TEST(OtherCar, RollAngleIsMomentOverStiffness) {
    const Params p = simple();
    const Car car = driven(p, 20, 4, [](double) { return Input{.steering_wheel = 0.3}; });
    const double axis =
        (p.front.roll_axis * (p.wheelbase - p.front_distance) + p.rear.roll_axis * p.front_distance) / p.wheelbase;
    const double arm = p.height - axis, ay = car.forces({.steering_wheel = 0.3}).ay;
    const double stiffness = p.front.rollStiffness() + p.rear.rollStiffness() - p.mass * kGravity * arm;
    EXPECT_GT(ay, 2);
    EXPECT_NEAR(car.state()[kRoll], p.mass * ay * arm / stiffness, 0.01 * p.mass * ay * arm / stiffness);
}

TEST(OtherCar, HeldStraightOnABankItLeansToTheLowSide) {
    Params p = simple();
    p.bank = 0.02;
    Car car(p, 20);
    for (int i = 0; i < 6000; ++i) {
        const Input held{.steering_wheel = -10 * car.state()[kYaw] - 5 * car.state()[kYawRate]};
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
    const Car car = driven(p, 20, 4, [](double) { return Input{.steering_wheel = 0.5}; });
    const Forces f = car.forces({.steering_wheel = 0.5});
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
    const Input turned{.steering_wheel = 0.01};
    const double length = axleStiffness(p, true) / 2 / p.front.tyre.carcass, time = length / kSpeed;
    for (int i = 0; i < static_cast<int>(std::lround(time / 1e-4)); ++i) car.step(turned, turned, 1e-4);
    EXPECT_NEAR(car.state()[kAlpha], (1 - std::exp(-1)) * 0.01 / p.steering_ratio, 0.05 * 0.01 / p.steering_ratio);
}

TEST(OtherCar, TyreGivesItsFrictionAndNoMore) {
    const Tyre tyre = compact().front.tyre;
    double most = 0;
    for (int i = 0; i < 100; ++i) {
        const TyreForce f = force(tyre, {}, tyre.nominal_load, 1, -0.003 * i, 0.004 * i, 0);
        most = std::max(most, std::hypot(f.fx, f.fy));
    }
    EXPECT_NEAR(most, tyre.friction * tyre.nominal_load, 0.01 * tyre.friction * tyre.nominal_load);
}

// ---- Structures (structure.h), each against what its formula says -------------------------------------------------

Tyre plainTyre() {
    Tyre tyre = compact().front.tyre;
    tyre.friction_by_load = 0;
    return tyre;
}

TEST(OtherCarStructure, TyresOfEachShapeHaveTheirStiffnessAndTheirFriction) {
    const Tyre tyre = plainTyre();
    const double load = tyre.nominal_load, peak = tyre.friction * load, small = 1e-5;
    for (const Structure& shape : {Structure{}, Structure{.brush_tyre = true}, Structure{.hyperbolic_tyre = true},
                                   Structure{.friction_ellipse = true}}) {
        EXPECT_NEAR(force(tyre, shape, load, 1, 0, small, 0).fy / small, corneringStiffness(tyre, load),
                    1e-3 * corneringStiffness(tyre, load));
        EXPECT_NEAR(force(tyre, shape, load, 1, small, 0, 0).fx / small, slipStiffness(tyre, load),
                    1e-3 * slipStiffness(tyre, load));
        for (double slip = 0; slip < 0.5; slip += 0.01) {
            const TyreForce f = force(tyre, shape, load, 1, 0.7 * slip, slip, 0);
            EXPECT_LE(std::hypot(f.fx, f.fy), 1.0001 * peak);
        }
    }
}

// Brush model: all of the contact slides from tan(alpha) = 3 friction load / stiffness on; half way to there the force
// is 7/8 of the friction.
TEST(OtherCarStructure, BrushTyreSlidesWhereItsFormulaSays) {
    const Tyre tyre = plainTyre();
    const double load = tyre.nominal_load, peak = tyre.friction * load;
    const double slides = 3 * peak / corneringStiffness(tyre, load);
    const Structure brush{.brush_tyre = true};
    EXPECT_NEAR(force(tyre, brush, load, 1, 0, std::atan(slides), 0).fy, peak, 1e-9 * peak);
    EXPECT_NEAR(force(tyre, brush, load, 1, 0, std::atan(2 * slides), 0).fy, peak, 1e-9 * peak);
    EXPECT_NEAR(force(tyre, brush, load, 1, 0, std::atan(slides / 2), 0).fy, 7.0 / 8 * peak, 1e-9 * peak);
    EXPECT_NEAR(force(tyre, brush, load, 1, 0, std::atan(slides), 0).trail, 0, 1e-9);
}

TEST(OtherCarStructure, EllipseLeavesTheSideForceTheRest) {
    const Tyre tyre = plainTyre();
    const double load = tyre.nominal_load, peak = tyre.friction * load;
    const Structure ellipse{.friction_ellipse = true};
    const double fx = force(tyre, ellipse, load, 1, 0.03, 0, 0).fx, fy = force(tyre, ellipse, load, 1, 0, 0.05, 0).fy;
    const TyreForce both = force(tyre, ellipse, load, 1, 0.03, 0.05, 0);
    EXPECT_NEAR(both.fx, fx, 1e-9 * peak);
    EXPECT_NEAR(both.fy, fy * std::sqrt(1 - fx * fx / (peak * peak)), 1e-9 * peak);
}

TEST(OtherCarStructure, TwistedBodyRollsMoreWhereItIsSofter) {
    // Held at both axles, the rear lags behind by what the twist carries over.
    Params p = simple();
    p.structure.body_twist = true;
    const Car car = driven(p, 20, 4, [](double) { return Input{.steering_wheel = 0.3}; });
    const double share = p.front_distance / p.wheelbase;
    const double axis =
        (p.front.roll_axis * (p.wheelbase - p.front_distance) + p.rear.roll_axis * p.front_distance) / p.wheelbase;
    const double front = car.state()[kRoll], rear = car.state()[kRearRoll];
    const double ay = car.forces({.steering_wheel = 0.3}).ay;
    const double moment = share * p.mass * (p.height - axis) * (ay + kGravity * rear);
    EXPECT_NEAR(moment + kTwistStiffness * (front - rear), p.rear.rollStiffness() * rear, 0.01 * moment);
}

TEST(OtherCarStructure, ColumnSwingsAboutTheAngleOfTheHand) {
    // Overshoot of an oscillator after a step: exp(-pi d / sqrt(1 - d^2)).
    Params p = simple();
    p.structure.steering_column = true;
    Car car(p, 20);
    double most = 0;
    for (int i = 0; i < 500; ++i) {
        car.step({.steering_wheel = 0.1}, {.steering_wheel = 0.1}, kStep);
        most = std::max(most, car.state()[kColumn]);
    }
    const double overshoot =
        std::exp(-std::numbers::pi * kColumnDamping / std::sqrt(1 - kColumnDamping * kColumnDamping));
    EXPECT_NEAR(most, 0.1 * (1 + overshoot), 1e-4);
    EXPECT_NEAR(car.state()[kColumn], 0.1, 1e-4);
}

TEST(OtherCarStructure, RearBrakesFillByTheirTimeConstant) {
    Params p = simple();
    p.structure.slow_rear_brakes = true;
    const Car car = driven(p, 30, kRearBrakeLag, [](double) { return Input{.brake = 0.2}; });
    EXPECT_NEAR(car.state()[kRearBrake], 0.2 * (1 - std::exp(-1)), 1e-6);
}

TEST(OtherCarStructure, TurboLeavesAShareOfTheTorqueForLater) {
    Params p = simple();
    Car at_once(p, 20);
    p.structure.turbo_lag = true;
    const Car turbo(p, 20);
    const double hold = turbo.holdingThrottle();
    const double missing = at_once.engineTorque({.throttle = 1}) - turbo.engineTorque({.throttle = 1});
    EXPECT_NEAR(missing, kTurboShare * (1 - hold) * valueAt(p.drive_full, turbo.engineSpeed()), 1e-9);
    EXPECT_EQ(at_once.engineTorque({.throttle = hold / 2}), turbo.engineTorque({.throttle = hold / 2}));
}

TEST(OtherCar, HalvingTheStepChangesNothing) {
    const Params p = compact();
    const Input turned{.steering_wheel = 0.6, .throttle = 0.3};
    Car coarse(p, 25), fine(p, 25);
    for (int i = 0; i < 1000; ++i) coarse.step(turned, turned, kStep);
    for (int i = 0; i < 2000; ++i) fine.step(turned, turned, kStep / 2);
    EXPECT_NEAR(coarse.state()[kYawRate], fine.state()[kYawRate], 1e-6);
    EXPECT_NEAR(coarse.state()[kRoll], fine.state()[kRoll], 1e-6);
}

}  // namespace
}  // namespace other_car::other_car_test
