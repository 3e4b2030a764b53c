// Sleep, snapshots, surfaces, ground that moves, and cars from files: what a RaycastVehicle has beyond the stock one.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "places/places.h"
#include "stock_vs_tread/scene.h"
#include "tread/load.h"

namespace tread {
namespace {

using namespace scene;
using DropIn = Car<RaycastVehicle>;

// A car on a kinematic floor that has fallen asleep.
struct Sleeper {
    Sleeper() {
        floor.setCollisionFlags(floor.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        floor.setActivationState(DISABLE_DEACTIVATION);
        car.brake(50);
        run(world, 6, 60);
    }
    World world;
    btRigidBody& floor{world.addBox(20, 0.5, 20, 0, vector(0, -0.5, 0))};
    DropIn car{world, {.sleeps = true}};
};

TEST(RaycastVehicleSleep, ParkedCarSleepsAndStaysWhereItIs) {
    Sleeper s;
    ASSERT_EQ(s.car.chassis->getActivationState(), ISLAND_SLEEPING);
    const btVector3 before = s.car.place();
    run(s.world, 60, 60);
    EXPECT_EQ(s.car.chassis->getActivationState(), ISLAND_SLEEPING);
    EXPECT_EQ((s.car.place() - before).length(), 0);
}

TEST(RaycastVehicleSleep, EveryInputWakes) {
    const std::vector<void (*)(RaycastVehicle&)> inputs{
        [](RaycastVehicle& car) { car.applyEngineForce(100, 2); }, [](RaycastVehicle& car) { car.setBrake(10, 3); },
        [](RaycastVehicle& car) { car.setSteeringValue(scalar(0.1), 0); },
        [](RaycastVehicle& car) { car.getWheelInfo(1).m_suspensionStiffness = 50; }};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        Sleeper s;
        inputs[i](*s.car.vehicle);
        run(s.world, 1.0 / 60, 60);
        EXPECT_TRUE(s.car.chassis->isActive()) << "input " << i;
    }
}

TEST(RaycastVehicleSleep, GroundThatMovesOrVanishesWakes) {
    Sleeper moved;
    moved.floor.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, -0.6, 0)));
    run(moved.world, 1, 60);
    EXPECT_NEAR(moved.car.place().y(), 0.4387, 0.02);

    Sleeper left;
    left.world.dynamics.removeRigidBody(&left.floor);
    run(left.world, 1, 60);
    EXPECT_LT(left.car.place().y(), -2) << "falls freely";
    left.world.dynamics.addRigidBody(&left.floor);
}

TEST(RaycastVehicleSleep, WokenFromOutsideItDoesNotJump) {
    Sleeper s;
    const double before = s.car.place().y();
    s.car.chassis->activate(true);
    double lowest = 1e9, highest = -1e9;
    for (int i = 0; i < 60; ++i) {
        run(s.world, 1.0 / 60, 60);
        lowest = std::min(lowest, static_cast<double>(s.car.place().y()));
        highest = std::max(highest, static_cast<double>(s.car.place().y()));
    }
    EXPECT_GT(lowest, before - 2e-5);
    EXPECT_LT(highest, before + 2e-5);
}

TEST(RaycastVehicleSleep, RollingSlowlyIsNoSleep) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 0.6, .sleeps = true});
    for (int i = 0; i < 4; ++i) car.vehicle->applyEngineForce(scalar(0.25 * 0.01 * 1500 * kGravity), i);
    run(world, 10, 60);
    EXPECT_TRUE(car.chassis->isActive());
    EXPECT_GT(car.place().z(), 3);
}

// ---- Snapshots ----

void wild(DropIn& car, int step) {
    car.steer(0.3 * std::sin(0.05 * step));
    car.push(step % 90 < 50 ? 6000 : 0);
    car.brake(step % 90 < 60 ? 0 : 60);
}

TEST(RaycastVehicleSnapshot, ReplayIsBitExact) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 15});
    for (int i = 0; i < 100; ++i) {
        wild(car, i);
        run(world, 1.0 / 60, 60);
    }
    const RaycastVehicleState kept = car.vehicle->snapshot();
    std::vector<RaycastVehicleState> first;
    for (int repeat = 0; repeat < 2; ++repeat) {
        car.vehicle->restore(kept);
        for (int i = 0; i < 200; ++i) {
            wild(car, 100 + i);
            run(world, 1.0 / 60, 60);
            const RaycastVehicleState now = car.vehicle->snapshot();
            if (repeat == 0) first.push_back(now);
            else {
                const RaycastVehicleState& then = first[static_cast<std::size_t>(i)];
                ASSERT_EQ(std::memcmp(then.pose.data(), now.pose.data(), sizeof now.pose), 0) << i;
                ASSERT_EQ(std::memcmp(then.velocity.data(), now.velocity.data(), sizeof now.velocity), 0) << i;
                ASSERT_EQ(then.car.wheels[2].rotation, now.car.wheels[2].rotation) << i;
            }
        }
    }
}

// ---- Grounds and surfaces ----

// What a locked wheel of the test's car gives over its load: the tyre's formulas at full slip.
double lockedFriction(double friction) {
    TyreParams tyre = similarTyre(0.25 * 1500 * kGravity, 0.3);
    tyre.lambda.mux = tyre.lambda.muy = friction;
    const double load = tyre.parameters.Fzo;
    return -steadyState(tyre, {.Fz = load, .gamma = 0, .Vx = 15, .Vsx = 15, .Vsy = 0}).Fx / load;
}

TEST(RaycastVehicleGround, TakesTheReactionOfTheCarThatDrivesOff) {
    World world;
    btRigidBody& plank = world.addBox(3, 0.1, 30, 3000, vector(0, -0.1, 0));
    plank.setGravity(vector(0, 0, 0));
    plank.setLinearFactor(vector(1, 0, 1));
    plank.setAngularFactor(0);
    plank.setDamping(0, 0);
    plank.setActivationState(DISABLE_DEACTIVATION);
    DropIn car(world);
    run(world, 1, 60);
    car.push(4000);
    run(world, 2, 60);
    const double car_momentum = 1500 * car.vehicle->velocity().z();
    const double plank_momentum = 3000 * static_cast<double>(plank.getLinearVelocity().z());
    EXPECT_GT(car_momentum, 4000);
    EXPECT_NEAR(plank_momentum, -car_momentum, 0.03 * car_momentum);
}

TEST(RaycastVehicleGround, SurfaceCallbackGivesFrictionAndName) {
    World world;
    btRigidBody& ground = world.addPlane();
    DropIn car(world, {.speed = 20});
    const btCollisionObject* asked = nullptr;
    car.vehicle->setSurface([&](const SurfaceQuery& query) {
        asked = query.object;
        return query.point.z() > 30 ? Surface{.friction = 0.2, .name = "ice"} : Surface{.name = "road"};
    });
    run(world, 0.5, 60);
    EXPECT_STREQ(car.vehicle->surfaceName(0), "road");
    EXPECT_EQ(asked, &ground);
    run(world, 2, 60);
    EXPECT_STREQ(car.vehicle->surfaceName(0), "ice");
    car.brake(1000);
    const double before = car.velocity().z();
    run(world, 1, 60);
    EXPECT_NEAR((before - car.velocity().z()) / kGravity, lockedFriction(0.2), 0.01);
}

TEST(RaycastVehicleGround, RoughSurfaceShakesTheWheels) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 20});
    car.vehicle->setSurface([](const SurfaceQuery&) { return Surface{.roughness = 0.01}; });
    run(world, 1, 250);
    double least = 1e9, most = 0;
    for (int i = 0; i < 250; ++i) {
        run(world, 0.004, 250);
        least = std::min(least, car.vehicle->telemetry(0).load);
        most = std::max(most, car.vehicle->telemetry(0).load);
    }
    EXPECT_GT(most - least, 500);
    EXPECT_LT(most, 3 * 0.25 * 1500 * kGravity);
}

// ---- Tyres and files ----

TEST(RaycastVehicleTyres, MayBeChangedWhileDriving) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 20});
    run(world, 1, 60);
    TyreParams worn = similarTyre(0.25 * 1500 * kGravity, 0.3);
    worn.lambda.mux = worn.lambda.muy = 0.5;
    for (int i = 0; i < 4; ++i) car.vehicle->setTyre(i, worn);
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
        expected += std::hypot(wheel.fx, wheel.fy) * car.vehicle->velocity().norm();
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
    RaycastVehicle vehicle(tuning, &chassis, &raycaster, sourceFile("vehicles/compact.yaml"));
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
    EXPECT_THROW(RaycastVehicle(tuning, &chassis, &raycaster, "no such file.yaml"), LoadError);
}

}  // namespace
}  // namespace tread
