// Sleep, snapshots, surfaces and ground that moves: what a RaycastVehicle has beyond the stock one.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "bullet/locked_friction.h"
#include "stock_vs_tread/scene.h"

namespace tread::raycast_state_test {
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
    const RaycastSnapshot kept = car.vehicle->snapshot();
    std::vector<RaycastSnapshot> first;
    for (int repeat = 0; repeat < 2; ++repeat) {
        car.vehicle->restore(kept);
        for (int i = 0; i < 200; ++i) {
            wild(car, 100 + i);
            run(world, 1.0 / 60, 60);
            const RaycastSnapshot now = car.vehicle->snapshot();
            if (repeat == 0) first.push_back(now);
            else {
                const RaycastSnapshot& then = first[static_cast<std::size_t>(i)];
                ASSERT_TRUE(then == now) << i;
            }
        }
    }
}

// ---- Grounds and surfaces ----

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

}  // namespace
}  // namespace tread::raycast_state_test
