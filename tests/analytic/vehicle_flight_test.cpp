// A car that touches nothing: momentum, free fall, reaction of the wheels' spin. What the road cannot hide.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "shared/vehicles.h"

namespace tread::vehicle_flight_test {
namespace {

const reference::NoRoad kNoRoad;
constexpr double kStep = 0.001;  // s

Vector3 axisOf(const reference::Car& car, std::size_t wheel) {
    const WheelState& state = car.state.wheels[wheel];
    const AxleParams& axle = wheel < 2 ? car.vehicle.params.front : car.vehicle.params.rear;
    const double camber = angles(axle.suspension, state.travel, wheel % 2 == 0).camber;
    return Eigen::AngleAxisd(state.steer, Vector3::UnitZ()) * Eigen::AngleAxisd(camber, Vector3::UnitX()) *
           Vector3::UnitY();
}

// Momentum of the car: a rigid body, wheels that spin, unsprung masses that move along the body's z axis.
Vector3 linearMomentum(const reference::Car& car) {
    const Vector3 up = car.motion.orientation * Vector3::UnitZ();
    Vector3 p = car.vehicle.params.mass * car.motion.velocity_W;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const WheelState& wheel = car.state.wheels[i];
        p += car.vehicle.corners[i].unsprung_mass *
             (wheel.rate * up + car.motion.angular_velocity_W.cross(wheel.travel * up));
    }
    return p;
}

// About the world's origin.
Vector3 angularMomentum(const reference::Car& car) {
    const InertiaParams& inertia = car.vehicle.params.inertia;
    const Vector3 v = car.motion.orientation.conjugate() * car.motion.velocity_W;
    const Vector3 w = car.motion.orientation.conjugate() * car.motion.angular_velocity_W;
    Vector3 l(inertia.roll * w.x() - inertia.roll_yaw * w.z(), inertia.pitch * w.y(),
              inertia.yaw * w.z() - inertia.roll_yaw * w.x());
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = car.vehicle.corners[i];
        l += corner.wheel_inertia * car.state.wheels[i].spin * axisOf(car, i);
        // Against a wheel at static height: there it moves with w x hub, here with w x (hub + travel) + rate.
        const WheelState& wheel = car.state.wheels[i];
        const Vector3 there = corner.hub_B + Vector3(0, 0, wheel.travel);
        const Vector3 velocity = v + w.cross(there) + Vector3(0, 0, wheel.rate);
        l += corner.unsprung_mass * (there.cross(velocity) - corner.hub_B.cross(v + w.cross(corner.hub_B)));
    }
    return car.motion.orientation * l + car.motion.position_W.cross(linearMomentum(car));
}

// Weightless: no springs are loaded, nothing moves but what is set spinning. The engine is declutched.
reference::Car weightless(const VehicleParams& params) {
    reference::Car car{.vehicle = prepare(params, 0), .road = kNoRoad};
    car.gravity_W.setZero();
    car.input.clutch = 1;
    return car;
}

// Without air, and without the belt's gyroscopic force on the contact patch, which is a mass beside the car's.
VehicleParams withoutAir(VehicleParams car) {
    car.aero = {};
    reference::simplify(car.front.tyre);
    reference::simplify(car.rear.tyre);
    return car;
}

struct Drift {
    double linear, angular;  // relative
};

Drift drift(reference::Car car, double duration, double dt) {
    car.step(1e-9);  // accelerations at the start
    const Vector3 p = linearMomentum(car), l = angularMomentum(car);
    Drift worst{0, 0};
    for (long k = 0; k < std::lround(duration / dt); ++k) {
        car.step(dt);
        worst.linear = std::max(worst.linear, (linearMomentum(car) - p).norm() / p.norm());
        worst.angular = std::max(worst.angular, (angularMomentum(car) - l).norm() / l.norm());
    }
    return worst;
}

TEST(Flight, SpinningAboutTheVerticalKeepsMomentumExactly) {
    // Nothing in this motion depends on the step: what drifts is rounding.
    constexpr double kRounding = 1e-9;
    reference::Car car = weightless(withoutAir(reference::simplified(reference::compact())));
    car.motion.velocity_W = {30, -4, 2};
    car.motion.angular_velocity_W = {0, 0, 3};
    const Drift still = drift(car, 2, kStep);
    std::printf("momentum over 2 s, spinning about the vertical: linear %.1e, angular %.1e\n", still.linear,
                still.angular);
    EXPECT_LT(still.linear, kRounding);
    EXPECT_LT(still.angular, kRounding);
}

TEST(Flight, TumblingWithSpinningWheelsKeepsMomentum) {
    // Light wheels on hard springs: the car is then rigid, and only the step is between it and Euler's equations.
    VehicleParams params = withoutAir(reference::compact());
    params.inertia.roll_yaw = 60;
    for (AxleParams* axle : {&params.front, &params.rear}) {
        axle->unsprung_mass = 1;
        axle->suspension.spring = 2e5;
    }
    reference::Car car = weightless(params);
    for (std::size_t i = 0; i < kWheels; ++i) car.state.wheels[i].spin = 60 + 10 * static_cast<double>(i);
    car.state.driveline = steadyDriveline(params.driveline, 65, 0).state;
    car.motion.velocity_W = {30, -4, 2};
    car.motion.angular_velocity_W = {1.5, 0.7, -2};
    const Drift coarse = drift(car, 2, 2 * kStep), fine = drift(car, 2, kStep);
    std::printf("momentum over 2 s, tumbling: linear %.1e, angular %.1e at 2 ms, %.1e at 1 ms (order %.2f)\n",
                fine.linear, coarse.angular, fine.angular, std::log2(coarse.angular / fine.angular));
    EXPECT_LT(fine.linear, 1e-7);
    EXPECT_LT(fine.angular, 1e-5) << "(w dt)^2 / 12 per radian turned, for about 100 radians of the wheels' precession";
    EXPECT_LT(fine.angular, coarse.angular);
}

TEST(Flight, HeavyWheelsOnTheirSpringsExchangeMomentumWithTheBody) {
    reference::Car car = weightless(withoutAir(reference::compact()));
    car.motion.velocity_W = {5, 0, 2};
    car.motion.angular_velocity_W = {1.5, 0.7, -0.5};
    for (std::size_t i = 0; i < kWheels; ++i) car.state.wheels[i].rate = i < 2 ? 0.5 : -0.3;
    const Drift coarse = drift(car, 2, 2 * kStep), d = drift(car, 2, kStep);
    std::printf("momentum over 2 s, tumbling, wheels swinging: linear %.1e, angular %.1e at 2 ms; %.1e, %.1e at 1 ms\n",
                coarse.linear, coarse.angular, d.linear, d.angular);
    EXPECT_LT(d.linear, 1e-5) << "0.5 m/s of wheel travel carry 1 % of the car's momentum: wrong forces show";
    EXPECT_LT(d.angular, 2e-5);
    EXPECT_LT(d.angular, coarse.angular);
}

TEST(Flight, NothingDependsOnTheSpeedOfTheObserver) {
    // Galilei: a car that tumbles at 40 m/s moves on its springs as one that tumbles in place.
    constexpr double kRounding = 1e-10;
    reference::Car still = weightless(withoutAir(reference::compact()));
    still.motion.angular_velocity_W = {0.5, 1.0, 0.3};
    for (std::size_t i = 0; i < kWheels; ++i) still.state.wheels[i].rate = i < 2 ? 0.5 : -0.3;
    reference::Car moving = still;
    moving.motion.velocity_W = {40, -6, 3};
    double travel = 0, turn = 0;
    for (double t = 0; t < 1; t += kStep) {
        still.step(kStep);
        moving.step(kStep);
        for (std::size_t i = 0; i < kWheels; ++i)
            travel = std::max(travel, std::abs(still.state.wheels[i].travel - moving.state.wheels[i].travel));
        turn = std::max(turn, (still.motion.angular_velocity_W - moving.motion.angular_velocity_W).norm());
    }
    std::printf("at 43 m/s instead of at rest: travel differs by %.1e m, angular velocity by %.1e rad/s\n", travel,
                turn);
    EXPECT_LT(travel, kRounding);
    EXPECT_LT(turn, kRounding);
}

TEST(Flight, FallsWithGravity) {
    for (const VehicleParams& shipped : {reference::compact(), reference::rearDriveSedan()}) {
        const PlaneRoad road;
        const reference::Car settled = reference::settled(withoutAir(shipped), road, {.input = {.brake = 1}});
        reference::Car car{.vehicle = settled.vehicle,
                           .road = kNoRoad,
                           .motion = settled.motion,
                           .state = settled.state,
                           .input = settled.input};
        const auto centre = [&] {
            double z = car.motion.position_W.z();
            for (std::size_t i = 0; i < kWheels; ++i)
                z += car.vehicle.corners[i].unsprung_mass / car.vehicle.params.mass * car.state.wheels[i].travel;
            return z;
        };
        car.step(1e-9);  // the road is gone: accelerations of that instant
        const double start = centre();
        double t = 0;
        for (int k = 0; k < 1000; ++k, t += kStep) car.step(kStep);
        const double fallen = start - centre();
        const double closed = 0.5 * kStandardGravity * t * t;
        std::printf("%s: falls %.5f m in a second, closed form %.5f m\n", shipped.name.c_str(), fallen, closed);
        EXPECT_NEAR(fallen, closed, 1e-5 * closed);
    }
}

// ---- Reaction of the wheels' spin ----

TEST(Flight, DrivenWheelsSpinningUpPitchTheBodyBackwards) {
    for (const VehicleParams& shipped : {reference::compact(), reference::rearDriveSedan()}) {
        VehicleParams params = withoutAir(reference::simplified(shipped));
        reference::Car car = weightless(params);
        car.input = {.throttle = 1};
        car.state.driveline = steadyDriveline(params.driveline, 20, 0).state;
        for (std::size_t i = 0; i < kWheels; ++i) car.state.wheels[i].spin = 20;
        double gained = 0;
        for (int k = 0; k < 300; ++k) {
            car.step(kStep);
            gained = 0;
            for (std::size_t i = 0; i < kWheels; ++i)
                gained += car.vehicle.corners[i].wheel_inertia * (car.state.wheels[i].spin - 20);
        }
        const double pitch_rate = car.output().chassis.pitch_rate;
        std::printf("%s: wheels gain %.2f N m s, body pitches at %.5f rad/s, closed form %.5f\n", shipped.name.c_str(),
                    gained, pitch_rate, -gained / params.inertia.pitch);
        EXPECT_GT(gained, 10);
        EXPECT_NEAR(pitch_rate, -gained / params.inertia.pitch, 0.01 * gained / params.inertia.pitch);
    }
}

TEST(Flight, BrakingTheWheelsPitchesTheBodyForwards) {
    VehicleParams params = withoutAir(reference::simplified(reference::compact()));
    reference::Car car = weightless(params);
    double before = 0;
    for (std::size_t i = 0; i < kWheels; ++i) {
        car.state.wheels[i].spin = 90;
        before += 90 * car.vehicle.corners[i].wheel_inertia;
    }
    car.input.brake = 1;
    for (int k = 0; k < 500; ++k) car.step(kStep);
    for (std::size_t i = 0; i < kWheels; ++i) EXPECT_EQ(car.state.wheels[i].spin, 0);
    EXPECT_NEAR(car.output().chassis.pitch_rate, before / params.inertia.pitch, 1e-3 * before / params.inertia.pitch);
}

TEST(Flight, SteeringSpinningWheelsRollsTheBody) {
    // Turning the wheels to the left tips their angular momentum (to the left, +y) backwards: by
    // I Omega sin(steer) about -x. The body takes the opposite.
    VehicleParams params = withoutAir(reference::simplified(reference::compact()));
    reference::Car car = weightless(params);
    for (std::size_t i = 0; i < kWheels; ++i) car.state.wheels[i].spin = 90;
    car.state.driveline = steadyDriveline(params.driveline, 90, 0).state;
    const double steer = 0.2;
    for (int k = 1; k <= 200; ++k) {
        VehicleInput next = car.input;
        next.steering_wheel_angle = params.steering.ratio * steer * k / 200;
        car.step(next, kStep);
    }
    const double rolled = 2 * params.front.wheel_inertia * 90 * std::sin(steer) / params.inertia.roll;
    std::printf("steering by %.1f rad with wheels spinning in the air: roll rate %.5f rad/s, closed form %.5f\n", steer,
                car.output().chassis.roll_rate, rolled);
    EXPECT_NEAR(car.output().chassis.roll_rate, rolled, 0.02 * rolled);
}

}  // namespace
}  // namespace tread::vehicle_flight_test
