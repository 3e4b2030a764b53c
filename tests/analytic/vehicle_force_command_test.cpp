// A commanded longitudinal force against the balance of forces, and the wheels at which it acts.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/vehicles.h"

namespace tread::vehicle_force_command_test {
namespace {

constexpr double kStep = 0.001;  // s
constexpr double kBalance = 0.01;

VehicleInput commanding(double force) {
    VehicleInput input;
    input.longitudinal_force = force;
    input.force_command = 1;
    return input;
}

double rollingResistance(const reference::Car& car) {
    double force = 0;  // N
    for (std::size_t i = 0; i < kWheels; ++i) {
        const TyreParams& tyre = car.vehicle.corners[i].tyre;
        force += tyre.parameters.qy1 * car.state.wheels[i].load * 2 / std::numbers::pi *
                 std::atan(tyre.parameters.Re * car.state.wheels[i].spin) / car.state.wheels[i].radius;  // (85)
    }
    return force;
}

double drag(const VehicleParams& params, double speed) {
    return 0.5 * params.aero.air_density * params.aero.drag_area * speed * speed;
}

// Mass that a longitudinal force has to accelerate: the car and its rolling wheels.
double effectiveMass(const VehicleParams& params) {
    double mass = params.mass;
    for (const AxleParams* axle : {&params.front, &params.rear})
        mass += 2 * axle->wheel_inertia / (axle->tyre.parameters.Re * axle->tyre.parameters.Re);
    return mass;
}

reference::Car after(const VehicleParams& params, const Road& road, double force, double duration) {
    reference::Car car = reference::settled(params, road, {.speed = 20});
    for (double t = 0; t < duration; t += kStep) car.step(commanding(force), kStep);
    return car;
}

TEST(ForceCommand, AcceleratesTheCarAgainstItsResistances) {
    const PlaneRoad road;
    for (VehicleParams params : {reference::compact(), reference::rearDriveSedan()}) {
        const double drag_area = params.aero.drag_area;
        params = reference::simplified(params);  // no toe, whose drag is not in the balance
        params.aero.drag_area = drag_area;
        for (const double force : {3000.0, 500.0, -500.0, -3000.0}) {
            reference::Car car = after(params, road, force, 2);
            const double mean_speed = car.output().chassis.vx;
            double gained = -mean_speed;
            for (int k = 0; k < 500; ++k) car.step(kStep);
            gained += car.output().chassis.vx;
            const double resistances = rollingResistance(car) + drag(params, mean_speed + 0.5 * gained);
            EXPECT_NEAR(effectiveMass(params) * gained / (500 * kStep), force - resistances, kBalance * std::abs(force))
                << params.name << " " << force;
        }
    }
}

TEST(ForceCommand, DrivesByTheDrivelinesSharesAndBrakesByTheBrakeBalance) {
    const PlaneRoad road;
    VehicleParams params = reference::compact();
    params.driveline.front_share = 0.6;
    params.brakes.front_share = 0.7;
    for (const double force : {2000.0, -2000.0}) {
        const reference::Car car = after(params, road, force, 2);
        double torque[2] = {0, 0};
        for (std::size_t i = 0; i < kWheels; ++i)
            torque[axleOf(i)] += force > 0 ? car.state.wheels[i].drive_torque : car.state.wheels[i].brake_torque;
        EXPECT_NEAR(torque[0] / (torque[0] + torque[1]), force > 0 ? 0.6 : 0.7, 1e-9);
        const double radius = 0.25 * (car.state.wheels[0].radius + car.state.wheels[1].radius +
                                      car.state.wheels[2].radius + car.state.wheels[3].radius);
        EXPECT_NEAR(torque[0] + torque[1], std::abs(force) * radius, 0.01 * std::abs(force) * radius);
    }
}

TEST(ForceCommand, IsLimitedByTheGripAndNotByTheEngine) {
    const PlaneRoad road;
    const VehicleParams params = reference::compact();
    for (const double force : {30000.0, -30000.0}) {
        reference::Car car = after(params, road, force, 0.5);
        for (int k = 0; k < 500; ++k) {
            car.step(kStep);
            for (std::size_t i = 0; i < kWheels; ++i) {
                const double rolling = car.vehicle.corners[i].tyre.parameters.Re * car.state.wheels[i].spin;
                ASSERT_LT(std::abs(rolling / car.output().chassis.vx - 1), 0.3) << "neither spins nor locks";
            }
        }
        EXPECT_GT(std::abs(car.output().chassis.ax), force > 0 ? 3.5 : 8.0) << "about what the driven tyres can do";
    }
}

TEST(ForceCommand, BrakesToStandstillAndHoldsThere) {
    const PlaneRoad road(-0.05);
    reference::Car car = after(reference::compact(), road, -4000, 12);
    const Vector3 from = car.motion.position_W;
    for (int k = 0; k < 2000; ++k) car.step(kStep);
    EXPECT_LT((car.motion.position_W - from).norm(), 1e-5);
}

TEST(ForceCommand, EngineGoesOnWhereTheCommandEnds) {
    const PlaneRoad road;
    const VehicleParams params = reference::compact();
    reference::Car car = reference::settled(params, road, {.speed = 20});
    const VehicleInput held = car.input;
    const double engine_speed = car.state.driveline.engine_speed;
    for (int k = 0; k < 1000; ++k) car.step(commanding(rollingResistance(car) + drag(params, 20)), kStep);
    EXPECT_NEAR(car.output().chassis.vx, 20, 0.02);
    for (int k = 0; k < 1000; ++k) car.step(held, kStep);
    EXPECT_NEAR(car.output().chassis.vx, 20, 0.05);
    EXPECT_NEAR(car.state.driveline.engine_speed, engine_speed, 0.01 * engine_speed);
}

}  // namespace
}  // namespace tread::vehicle_force_command_test
