// Tyres that differ from what their file says: in pull, temperature, pressure, and from wheel to wheel.

#include <gtest/gtest.h>

#include <cstdio>

#include "shared/single_track.h"

namespace tread::vehicle_tyres_test {
namespace {

using reference::kStep;

// Yaw rate with the steering wheel held straight.
double yawRate(const VehicleParams& params, double speed = 20) {
    const PlaneRoad road;
    reference::Car car = reference::settled(params, road, {.speed = speed});
    VehicleInput in = car.input;
    in.steering_wheel_angle = 0;  // where the start held it against the pull
    for (double t = 0; t < 3; t += kStep) car.step(in, kStep);
    return car.output().chassis.yaw_rate;
}

VehicleParams symmetric() {
    VehicleParams params = reference::compact();
    params.aero = {};
    for (AxleParams* axle : {&params.front, &params.rear}) {
        TyreCoefficients& p = axle->tyre.parameters;
        for (double* odd : {&p.pHy1, &p.pHy2, &p.pVy1, &p.pVy2, &p.pEy3, &p.qHz1, &p.qHz2, &p.qDz6, &p.qDz7, &p.ssz1})
            *odd = 0;
    }
    return params;
}

TEST(TyresOfACar, PlySteerActsAsASteeringWheelTurnedByThatAngle) {
    VehicleParams params = symmetric();
    params.front.tyre_surroundings.ply_steer = 0.001;
    const double pulled = yawRate(params);
    const PlaneRoad road;
    reference::Car steered = reference::settled(symmetric(), road, {.speed = 20});
    VehicleInput in = steered.input;
    in.steering_wheel_angle = 0.001 * params.steering.ratio;
    for (double t = 0; t < 3; t += kStep) steered.step(in, kStep);
    EXPECT_GT(pulled, 0.001) << "positive pulls to the left";
    EXPECT_NEAR(pulled, steered.output().chassis.yaw_rate, 0.01 * pulled);
}

TEST(TyresOfACar, ConicityOfEqualTyresCancelsAndOfOneTyrePullsToItsSide) {
    VehicleParams both = symmetric();
    both.front.tyre_surroundings.conicity = 0.01;
    EXPECT_NEAR(yawRate(both), 0, 1e-9);
    TyreSurroundingsParams conical;
    conical.conicity = 0.01;
    VehicleParams left = symmetric(), right = symmetric();
    left.front.left.tyre_surroundings = conical;
    right.front.right.tyre_surroundings = conical;
    EXPECT_GT(yawRate(left), 1e-4) << "as if its top leant to the left";
    EXPECT_NEAR(yawRate(right), -yawRate(left), 1e-9);
}

TEST(TyresOfACar, OneWheelMayWearAnotherTyre) {
    VehicleParams params = symmetric();
    params.rear.right.tyre = params.rear.tyre;
    params.rear.right.tyre->lambda.muy = 0.5;
    params.rear.right.tyre->parameters.Ro -= 0.005;
    const Vehicle vehicle = prepare(params);
    EXPECT_EQ(vehicle.corners[3].tyre.lambda.muy, 0.5);
    EXPECT_EQ(vehicle.corners[2].tyre.lambda.muy, 1);
    EXPECT_NEAR(vehicle.corners[2].hub_B.z() - vehicle.corners[3].hub_B.z(), 0.005, 1e-5) << "it stands lower";
    EXPECT_EQ(vehicle.corners[3].tyre.side, TyreSide::right) << "mounted as any other tyre";
}

TEST(TyresOfACar, LowPressureLetsTheWheelSinkByTheClosedForm) {
    VehicleParams params = symmetric();
    TyreSurroundingsParams flat;
    flat.pressure = {.inflation = 110000, .nominal = 220000, .radial_stiffness = 0.8};
    params.front.left.tyre_surroundings = flat;
    const PlaneRoad road;
    const reference::Car car = reference::settled(params, road, {.input = {.brake = 0.5}});
    const WheelState &soft = car.state.wheels[0], &hard = car.state.wheels[1];
    const TyreCoefficients& p = params.front.tyre.parameters;
    EXPECT_NEAR(p.Ro - soft.radius, soft.load / (0.6 * p.pz1), 1e-6);
    EXPECT_NEAR(p.Ro - hard.radius, hard.load / p.pz1, 1e-6);
}

// A car whose rear wheels, which nothing drives or brakes, roll without slip.
VehicleParams rollingOnAVariableRadius() {
    VehicleParams params = symmetric();
    TyreCoefficients& p = params.rear.tyre.parameters;
    p.pHx1 = p.pHx2 = p.pVx1 = p.pVx2 = p.qy1 = p.qy2 = 0;
    p.pRe1 = -0.02;
    return params;
}

TEST(TyresOfACar, WheelsRollOnARadiusThatFallsWithTheirLoad) {
    const VehicleParams params = rollingOnAVariableRadius();
    const TyreCoefficients& p = params.rear.tyre.parameters;
    const PlaneRoad road;
    const reference::Car car = reference::steadyTurn(params, road, 20, 0.05, 12);
    double least = kInfinity, most = 0;
    for (const std::size_t i : {2u, 3u}) {
        const WheelState& w = car.state.wheels[i];
        const double expected = p.Re * (1 - 0.02 * (w.load / p.Fzo - 1));
        std::printf("rear tyre %zu: %.0f N, %.3f mm\n", i, w.load, 1000 * expected);
        EXPECT_NEAR(w.motion.Vx / w.spin, expected, 2e-5 * expected);
        EXPECT_NEAR(car.output().wheel[i].slip_ratio, 0, 2e-5);
        least = std::min(least, expected);
        most = std::max(most, expected);
    }
    EXPECT_GT(most - least, 0.003) << "the turn shifts load";
}

// The start is the state in which the wheels roll.
TEST(TyresOfACar, WheelsStartOnTheRadiusOfTheirLoad) {
    const VehicleParams params = rollingOnAVariableRadius();
    const PlaneRoad road;
    const reference::Car car = reference::settled(params, road, {.speed = 20});
    const WheelState& w = car.state.wheels[2];
    const TyreCoefficients& p = params.rear.tyre.parameters;
    EXPECT_NEAR(w.spin, 20 / (p.Re * (1 - 0.02 * (w.load / p.Fzo - 1))), 1e-5 * w.spin);
    EXPECT_GT(std::abs(w.load / p.Fzo - 1), 0.2);
}

TEST(TyresOfACar, TemperatureInASteadyTurnIsThatOfItsSlipPower) {
    VehicleParams params = symmetric();
    params.rear.tyre_surroundings.temperature.heat_capacity = 0;
    TyreTemperatureParams& t = params.front.tyre_surroundings.temperature;
    t = {
        .start = 293.15, .air = 288.15, .heat_capacity = 20, .slip_share = 0.6, .cooling = 10, .cooling_by_speed = 0.5};
    const PlaneRoad road;
    const reference::Car car = reference::steadyTurn(params, road, 20, 0.05, 12);
    for (const std::size_t i : {0u, 1u}) {
        const WheelState& w = car.state.wheels[i];
        const WheelOutput out = car.output().wheel[i];
        // Steady: the patch slips as the rim does.
        const double power = -w.fx * (w.motion.Vx - params.front.tyre.parameters.Re * w.spin) + w.fy * w.motion.Vsy;
        const double expected = 288.15 + 0.6 * power / (10 + 0.5 * w.motion.Vx);
        std::printf("front tyre %zu: %.0f W, %.2f K, closed form %.2f K\n", i, power, out.temperature, expected);
        EXPECT_GT(power, 500);
        EXPECT_NEAR(out.temperature - 288.15, expected - 288.15, 0.01 * (expected - 288.15));
    }
    EXPECT_EQ(car.output().wheel[2].temperature, 293.15) << "the rear tyres keep theirs";
}

TEST(TyresOfACar, TyresThatHeatRobsOfATenthOfTheirGripStopAsOnARoadOfThatFriction) {
    const auto distance = [](double start, double friction) {
        VehicleParams params = symmetric();
        for (AxleParams* axle : {&params.front, &params.rear}) {
            axle->tyre_surroundings.temperature.heat_capacity = 0;
            axle->tyre_surroundings.temperature.start = start;
            axle->tyre_surroundings.temperature.friction = -0.002;
        }
        const PlaneRoad road(0, 0, friction);
        reference::Car car = reference::settled(params, road, {.speed = 20});
        const double from = car.motion.position_W.x();
        VehicleInput in = car.input;
        in.throttle = 0;
        in.clutch = in.brake = 1;
        for (double t = 0; t < 6; t += kStep) car.step(in, kStep);
        return car.motion.position_W.x() - from;
    };
    EXPECT_NEAR(distance(343.15, 1), distance(293.15, 0.9), 1e-6);
    EXPECT_GT(distance(343.15, 1), 1.05 * distance(293.15, 1));
}

TEST(TyresOfACar, GripDifferencePullsABrakingCarToTheSideOfMoreGrip) {
    VehicleParams params = symmetric();
    for (AxleParams* axle : {&params.front, &params.rear}) axle->tyre_surroundings.grip_difference = 0.1;
    const Vehicle car = prepare(params);
    EXPECT_DOUBLE_EQ(car.corners[0].tyre.lambda.muy, 1.05);
    EXPECT_DOUBLE_EQ(car.corners[3].tyre.lambda.mux, 0.95);
    const PlaneRoad road;
    reference::Car driven = reference::settled(params, road, {.speed = 20});
    VehicleInput in = driven.input;
    in.throttle = 0;
    in.clutch = in.brake = 1;  // locks the wheels
    for (double t = 0; t < 1; t += kStep) driven.step(in, kStep);
    EXPECT_GT(driven.output().chassis.yaw_rate, 0.1) << "to the left";
}

// ---- Starting straight on ----

void expectStraight(const VehicleParams& params, const Road& road) {
    reference::Car car = reference::settled(params, road, {.speed = 25});
    const Equilibrium start = equilibrium(car.vehicle, {road, car.gravity_W}, {.speed = 25});
    EXPECT_LT(start.acceleration, 1e-5);
    for (double t = 0; t < 2; t += kStep) car.step(kStep);
    EXPECT_NEAR(car.output().chassis.yaw_rate, 0, 1e-4);
    EXPECT_NEAR(car.output().chassis.ay, 0, 1e-3);
}

TEST(TyresOfACar, APullIsSteeredAgainstFromTheStart) {
    const PlaneRoad road;
    VehicleParams params = symmetric();
    params.front.tyre_surroundings.ply_steer = 0.001;
    expectStraight(params, road);
    const Equilibrium start = equilibrium(prepare(params), {road, {0, 0, -kStandardGravity}}, {.speed = 25});
    EXPECT_NEAR(start.input.steering_wheel_angle, -0.001 * params.steering.ratio, 0.01 * 0.001 * params.steering.ratio);
    EXPECT_NEAR(start.motion.velocity_W.y(), 0, 1e-3);

    // Rear tyres that pull turn the car askew: it goes straight on with its sideslip, the front wheels parallel.
    params = symmetric();
    params.rear.tyre_surroundings.ply_steer = 0.001;
    expectStraight(params, road);
    const Equilibrium askew = equilibrium(prepare(params), {road, {0, 0, -kStandardGravity}}, {.speed = 25});
    EXPECT_NEAR(askew.motion.velocity_W.y() / 25, 0.001, 0.02 * 0.001);
    EXPECT_NEAR(askew.input.steering_wheel_angle, 0.001 * params.steering.ratio, 0.02 * 0.001 * params.steering.ratio);

    params.steering.delay = 0.1;
    params.steering.lag = 0.05;
    params.steering.rack_compliance = 2e-5;
    expectStraight(params, road);
}

TEST(TyresOfACar, ABankIsSteeredAgainstFromTheStart) {
    const PlaneRoad bank(0, 0.03, 1);
    expectStraight(reference::compact(), bank);
    expectStraight(reference::rearDriveSedan(), bank);
}

}  // namespace
}  // namespace tread::vehicle_tyres_test
