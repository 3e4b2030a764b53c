// What yields in suspension and steering shifts the understeer gradient by as much as the closed form says; a released
// steering wheel goes back.

#include <gtest/gtest.h>

#include <cstdio>

#include "shared/single_track.h"

namespace tread::vehicle_compliance_test {
namespace {

using reference::kDegree;
using reference::kStep;

constexpr double kGradient = kDegree / kStandardGravity;  // rad s2/m in a deg/g

// Steer angle beyond L / R over lateral acceleration, driven.
double understeer(VehicleParams params, double speed) {
    const PlaneRoad road;
    const double steer = 0.2 * (params.wheelbase / (speed * speed) + reference::singleTrack(params).understeer);
    const reference::Car car = reference::steadyTurn(params, road, speed, steer, 8);
    const ChassisOutput out = car.output().chassis;
    const double v = std::hypot(out.vx, out.vy);
    return (steer - params.wheelbase * out.yaw_rate / v) / (v * out.yaw_rate);
}

// Rolling resistance grows with the load and turns the car outwards: the single track knows no sides.
VehicleParams plainCar() {
    VehicleParams params = reference::simplified(reference::compact());
    params.front.tyre.lambda.My = params.rear.tyre.lambda.My = 0;
    return params;
}

TEST(Compliance, EachShiftsTheUndersteerGradientByTheClosedForm) {
    struct Effect {
        const char* name;
        void (*set)(VehicleParams&);
    };
    const Effect effects[] = {
        {"front steer by lateral force", [](VehicleParams& p) { p.front.suspension.steer_by_lateral_force -= 5e-6; }},
        {"front steer by aligning moment",
         [](VehicleParams& p) { p.front.suspension.steer_by_aligning_moment = 5e-5; }},
        {"rear steer by aligning moment", [](VehicleParams& p) { p.rear.suspension.steer_by_aligning_moment = 5e-5; }},
        {"front camber by lateral force", [](VehicleParams& p) { p.front.suspension.camber_by_lateral_force = 1e-5; }},
        {"rear camber by lateral force", [](VehicleParams& p) { p.rear.suspension.camber_by_lateral_force = 1e-5; }},
        {"column compliance", [](VehicleParams& p) { p.steering.column_compliance = 0.01; }},
        {"rack compliance", [](VehicleParams& p) { p.steering.rack_compliance = 5e-5; }},
        {"rack compliance with caster trail",
         [](VehicleParams& p) {
             p.steering.rack_compliance = 5e-5;
             p.steering.caster_trail = 0.025;
         }},
        {"column and rack compliance", [](VehicleParams& p) {
             p.steering.column_compliance = 0.01;
             p.steering.rack_compliance = 3e-5;
             p.steering.caster_trail = 0.02;
         }}};
    constexpr double kSpeed = 25;  // m/s
    VehicleParams plain = plainCar();
    // Camber thrust, which the simple tyre has not.
    plain.front.tyre.parameters.pVy3 = plain.rear.tyre.parameters.pVy3 = 0.5;
    const double before = understeer(plain, kSpeed), model_before = reference::singleTrack(plain).understeer;
    for (const Effect& effect : effects) {
        VehicleParams changed = plain;
        effect.set(changed);
        const double shift = understeer(changed, kSpeed) - before;
        const double expected = reference::singleTrack(changed).understeer - model_before;
        std::printf("%s: %+.4f deg/g, closed form %+.4f\n", effect.name, shift / kGradient, expected / kGradient);
        EXPECT_GT(std::abs(expected), 0.05 * kGradient) << effect.name;
        EXPECT_NEAR(shift, expected, 0.01 * std::abs(expected)) << effect.name;
    }
}

TEST(Compliance, StaysStableHoweverMuchTheSteeringYields) {
    // Ten times what a car has, and the step from coarse to fine: the loop through the tyre neither swings nor grows.
    const PlaneRoad road;
    VehicleParams params = plainCar();
    params.steering.rack_compliance = 1e-3;
    params.steering.caster_trail = 0.04;
    params.front.suspension.steer_by_aligning_moment = 5e-4;
    for (const double dt : {0.002, 0.001, 0.0001}) {
        reference::Car car = reference::settled(params, road, {.speed = 30});
        VehicleInput turned = car.input;
        turned.steering_wheel_angle = 0.5;
        car.step(turned, dt);
        for (double t = 0; t < 3; t += dt) car.step(dt);
        const double before = car.state.wheels[0].steer;
        for (int i = 0; i < 5; ++i) {
            const double last = car.state.wheels[0].steer;
            car.step(dt);
            EXPECT_LT(std::abs(car.state.wheels[0].steer - last), 1e-5);
        }
        EXPECT_NEAR(car.state.wheels[0].steer, before, 1e-4) << dt;
        EXPECT_GT(before, 0.001);
    }
}

TEST(Compliance, RollsStraightAtEverySpeedHoweverMuchItYields) {
    // Fast, the belt resists the turning of the wheel more than all else does: with a massless steering that is stiff.
    // The least is all but rigid, the most a hundred times what a car has.
    constexpr double kStiff = 1e-6, kSoft = 1e-3;  // rad/(N m), at the road wheels
    constexpr double kSwing = 1e-4;                // rad, of the nudge's 6e-4, in ten steps
    const PlaneRoad road;
    for (const double speed : {2.0, 15.0, 33.0, 50.0, 75.0}) {
        for (double yields = kStiff; yields < 1.5 * kSoft; yields *= std::sqrt(10)) {
            for (const bool suspension : {false, true}) {
                for (const double dt : {0.002, 0.001, 0.0005}) {
                    VehicleParams params = reference::compact();
                    if (suspension) {
                        params.front.suspension.steer_by_aligning_moment = 2 * yields;
                        params.rear.suspension.steer_by_aligning_moment = yields;
                    } else {
                        params.steering.column_compliance = yields * params.steering.ratio * params.steering.ratio;
                        params.steering.caster_trail = 0.03;
                    }
                    reference::Car car = reference::settled(params, road, {.speed = speed});
                    // A nudge of the steering wheel and back leaves nothing that swings.
                    VehicleInput nudged = car.input;
                    nudged.steering_wheel_angle += 0.01;
                    const VehicleInput straight = car.input;
                    car.step(nudged, dt);
                    for (double t = 0; t < 0.5; t += dt) car.step(straight, dt);
                    double change = 0, last = car.state.wheels[0].steer;
                    for (int i = 0; i < 10; ++i) {
                        car.step(straight, dt);
                        change += std::abs(car.state.wheels[0].steer - last);
                        last = car.state.wheels[0].steer;
                    }
                    EXPECT_LT(change, kSwing)
                        << speed << " m/s, " << yields << " rad/(N m), suspension " << suspension << ", step " << dt;
                }
            }
        }
    }
}

TEST(Compliance, StepSizeConvergesWithSecondOrder) {
    const PlaneRoad road;
    VehicleParams params = plainCar();
    params.steering.rack_compliance = 5e-5;
    params.steering.column_compliance = 0.01;
    params.steering.caster_trail = 0.02;
    params.rear.suspension.steer_by_aligning_moment = 3e-5;
    const reference::Car start = reference::settled(params, road, {.speed = 25});
    const auto lateral = [&](double dt) {
        reference::Car car = start;
        for (long k = 1; k <= std::lround(0.8 / dt); ++k) {
            VehicleInput in = start.input;
            const double x = std::min(static_cast<double>(k) * dt / 0.4, 1.0);
            in.steering_wheel_angle = 0.6 * x * x * x * (10 + x * (6 * x - 15));
            car.step(in, dt);
        }
        return car.output().chassis.y;
    };
    const double truth = lateral(2.5e-5);
    const double coarse = std::abs(lateral(2e-3) - truth), normal = std::abs(lateral(1e-3) - truth),
                 fine = std::abs(lateral(5e-4) - truth);
    std::printf("yielding steering: errors at 2, 1, 0.5 ms: %.1e %.1e %.1e of %.3f m\n", coarse, normal, fine, truth);
    EXPECT_LT(normal, 3e-4 * truth);
    EXPECT_GT(std::log2(coarse / normal), 1.5);
    EXPECT_GT(std::log2(normal / fine), 1.5);
}

// ---- Hands off ----

VehicleParams selfSteering() {
    VehicleParams params = plainCar();
    params.steering.caster_trail = 0.03;
    params.steering.inertia = 0.05;
    params.steering.damping = 0.8;
    return params;
}

TEST(HandsOff, TheCarGoesStraightAgain) {
    const PlaneRoad road;
    reference::Car car = reference::steadyTurn(selfSteering(), road, 20, 0.02, 4);
    const double held = car.state.steering.angle;
    EXPECT_GT(car.output().steering.torque, 1) << "the driver pulls to the left in a left turn";
    VehicleInput in = car.input;
    in.hands_off = 1;
    for (double t = 0; t < 4; t += kStep) car.step(in, kStep);
    EXPECT_EQ(car.output().steering.torque, 0);
    EXPECT_LT(std::abs(car.state.steering.angle), 0.02 * held);
    EXPECT_LT(std::abs(car.output().chassis.yaw_rate), 0.005);
}

TEST(HandsOff, FrictionLeavesItWhereItsMomentEquals) {
    const PlaneRoad road;
    VehicleParams params = selfSteering();
    params.steering.friction = 1.5;
    reference::Car car = reference::steadyTurn(params, road, 20, 0.02, 4);
    VehicleInput in = car.input;
    in.hands_off = 1;
    for (double t = 0; t < 6; t += kStep) car.step(in, kStep);
    EXPECT_EQ(car.state.steering.rate, 0) << "dry friction holds the wheel";
    EXPECT_GT(std::abs(car.state.steering.angle), 0.005) << "without friction it would go back to zero";
    const double left =
        steeringMoment(params.steering, car.state.wheels[0].fx, car.state.wheels[0].fy, car.state.wheels[0].mz, true);
    const double right =
        steeringMoment(params.steering, car.state.wheels[1].fx, car.state.wheels[1].fy, car.state.wheels[1].mz, false);
    EXPECT_LT(std::abs(left + right) / params.steering.ratio, 1.05 * 1.5);
}

TEST(HandsOff, ASnapshotIsACopy) {
    const PlaneRoad road;
    VehicleParams params = selfSteering();
    params.steering.delay = 0.03;
    params.steering.lag = 0.05;
    params.steering.play = 0.02;
    params.steering.rack_compliance = 2e-5;
    params.front.suspension.longitudinal_compliance = 1e-6;
    params.front.tyre_surroundings.temperature.heat_capacity = 2000;
    reference::Car car = reference::settled(params, road, {.speed = 20});
    const auto drive = [&](int from, int to) {
        for (int k = from; k < to; ++k) {
            VehicleInput in = car.input;
            in.steering_wheel_angle = std::sin(0.01 * k);
            in.hands_off = k / 200 % 2 == 1 ? 1 : 0;
            car.step(in, kStep);
        }
    };
    drive(0, 500);
    const auto motion = car.motion;
    const auto state = car.state;
    const auto input = car.input;
    drive(500, 1000);
    const ChassisMotion end = car.motion;
    car.motion = motion;
    car.state = state;
    car.input = input;
    drive(500, 1000);
    EXPECT_EQ(car.motion.position_W, end.position_W);
    EXPECT_EQ(car.motion.angular_velocity_W, end.angular_velocity_W);
}

}  // namespace
}  // namespace tread::vehicle_compliance_test
