// Tyres of a RaycastVehicle: changed while driving, seen by telemetry, read from a car's file.

#include <gtest/gtest.h>

#include <cmath>

#include "bullet/locked_friction.h"
#include "places/places.h"
#include "stock_vs_tread/scene.h"
#include "tread/load.h"
#include "tread/raycast_vehicle_file.h"

namespace tread::raycast_tyres_test {
namespace {

using namespace scene;
using DropIn = Car<RaycastVehicle>;

TEST(RaycastVehicleTyres, MayBeChangedWhileDriving) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 20});
    run(world, 1, 60);
    TyreParams worn = similarTyre(0.25 * 1500 * kGravity, 0.3);
    worn.lambda.mux = worn.lambda.muy = 0.5;
    for (int i = 0; i < 4; ++i) setTyre(*car.vehicle, i, worn);
    car.brake(1000);
    run(world, 0.5, 60);
    const double before = car.velocity().z();
    run(world, 0.5, 60);
    EXPECT_NEAR((before - car.velocity().z()) / 0.5 / kGravity, lockedFriction(0.5), 0.02);
}

TEST(RaycastVehicleTyres, TelemetryTellsSteeringTorqueAndSideForce) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 20});
    run(world, 1, 60);
    car.steer(0.08);
    run(world, 1, 60);
    const double torque = car.vehicle->telemetry(0).steer_torque + car.vehicle->telemetry(1).steer_torque;
    EXPECT_LT(torque, -20) << "the road turns the wheels back";
    EXPECT_GT(car.vehicle->telemetry(0).fy, 500);
}

TEST(RaycastVehicleTyres, TelemetryTellsSlipPowerOfLockedWheels) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 20});
    run(world, 1, 60);
    EXPECT_LT(car.vehicle->telemetry(0).slip_power, 50) << "of a wheel that rolls";
    car.brake(1000);
    run(world, 0.3, 60);
    // All of it is lost in the contact; on the mean, for the patch swings against the rim.
    double power = 0, expected = 0;
    for (int i = 0; i < 30; ++i) {
        run(world, 1.0 / 60, 60);
        const WheelTelemetry wheel = car.vehicle->telemetry(0);
        power += wheel.slip_power;
        expected += std::hypot(wheel.fx, wheel.fy) * car.vehicle->velocity().length();
    }
    EXPECT_NEAR(power, expected, 0.03 * expected);
    const WheelTelemetry locked = car.vehicle->telemetry(0);
    EXPECT_NEAR(locked.slip_ratio, -1, 1e-6);
    EXPECT_LT(car.vehicle->getWheelInfo(0).m_skidInfo, 0.3);
}

TEST(RaycastVehicleFile, GivesTyresAndSuspensionOfTheCar) {
    const VehicleParams compact = loadVehicle(sourceFile("vehicles/compact.yaml"));
    World world;
    world.addPlane();
    btBoxShape shape(vector(0.8, 0.25, 2));
    btRigidBody chassis(scalar(compact.mass), nullptr, &shape, vector(1750, 1950, 480));
    chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, 0.6, 0)));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    world.dynamics.addRigidBody(&chassis);
    btRaycastVehicle::btVehicleTuning tuning;
    btDefaultVehicleRaycaster raycaster(&world.dynamics);
    RaycastVehicle vehicle(tuning, &chassis, &raycaster);
    setVehicle(vehicle, sourceFile("vehicles/compact.yaml"));
    world.dynamics.addVehicle(&vehicle);
    for (int i = 0; i < 4; ++i)
        vehicle.addWheel(vector(i % 2 ? -0.76 : 0.76, 0, i < 2 ? 1.03 : -1.59), vector(0, -1, 0), vector(-1, 0, 0),
                         scalar(0.4), scalar(0.313), tuning, i < 2);
    run(world, 8, 60);

    // Springs of the file carry the weight: load over spring rate and over tyre rate.
    const double front_load = compact.mass * kGravity * 1.59 / 2.62 / 2;
    const WheelTelemetry front = vehicle.telemetry(0);
    EXPECT_NEAR(front.load, front_load, 0.02 * front_load);
    EXPECT_NEAR(front.compression, front.load / compact.front.suspension.spring, 1e-3);
    EXPECT_NEAR(front.deflection, front.load / compact.front.tyre.parameters.pz1, 1e-4);
    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
    EXPECT_THROW(setVehicle(vehicle, "no such file.yaml"), LoadError);
}

}  // namespace
}  // namespace tread::raycast_tyres_test
