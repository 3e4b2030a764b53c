// How a game calls a RaycastVehicle: before the chassis is built, twice a frame, through Bullet's own step, with
// callbacks that throw.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <new>
#include <stdexcept>

#include "bullet/locked_friction.h"
#include "stock_vs_tread/scene.h"

namespace tread::raycast_calls_test {
namespace {

using namespace scene;
using DropIn = Car<RaycastVehicle>;

TEST(RaycastVehicleCalls, ConstructorDoesNotTouchAChassisThatIsNotBuiltYet) {
    alignas(btRigidBody) unsigned char place[sizeof(btRigidBody)], before[sizeof(btRigidBody)];
    std::memset(place, 0xAB, sizeof place);
    std::memcpy(before, place, sizeof place);
    World world;
    world.addPlane();
    auto* chassis = reinterpret_cast<btRigidBody*>(place);
    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = 40;
    tuning.m_suspensionCompression = tuning.m_suspensionDamping = 4;
    RaycastVehicle vehicle(tuning, chassis, nullptr);
    vehicle.setCoordinateSystem(0, 1, 2);
    vehicle.setGrip(1);
    vehicle.setSubstep(0.01);
    vehicle.setCollisionFilter(1, -1);
    EXPECT_EQ(std::memcmp(place, before, sizeof place), 0);

    btBoxShape shape(vector(0.8, 0.25, 2));
    btVector3 inertia;
    shape.calculateLocalInertia(800, inertia);
    new (place) btRigidBody(800, nullptr, &shape, inertia);
    chassis->setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, 0.6, 0)));
    for (int i = 0; i < 4; ++i)
        vehicle.addWheel(vector(i % 2 ? -0.7 : 0.7, 0, i < 2 ? 1.3 : -1.3), vector(0, -1, 0), vector(-1, 0, 0),
                         scalar(0.3), scalar(0.3), tuning, i < 2);
    world.dynamics.addRigidBody(chassis);
    world.dynamics.addVehicle(&vehicle);
    run(world, 3, 60);
    EXPECT_NEAR(chassis->getCenterOfMassPosition().y(), 0.6 - kGravity / 4 / 40, 0.01) << "a spring of 40 N/m per kg";
    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(chassis);
    chassis->~btRigidBody();
}

// A game that adds the vehicle to the world and steps it by hand as well.
struct Gain {
    double speed;   // m/s, in two seconds of 2 kN
    double height;  // m
};
template <class Vehicle>
Gain driveOff(int steps_per_frame) {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.speed = 30});
    car.push(2000);
    for (int frame = 0; frame < 120; ++frame) {
        run(world, 1.0 / 60, 60);
        for (int i = 1; i < steps_per_frame; ++i) car.vehicle->updateVehicle(scalar(1.0 / 60));
    }
    return {car.velocity().z() - scalar(30), car.place().y()};
}

TEST(RaycastVehicleCalls, SecondStepWithinAFrameActsTwiceAsInStock) {
    const Gain once = driveOff<RaycastVehicle>(1), twice = driveOff<RaycastVehicle>(2);
    const Gain stock_once = driveOff<btRaycastVehicle>(1), stock_twice = driveOff<btRaycastVehicle>(2);
    const double mass = 1500 * (1 + 0.6 * 0.05);  // the wheels' inertia as well
    EXPECT_NEAR(once.speed, (2000 / mass - 0.01 * kGravity) * 2, 0.1) << "force less rolling resistance over mass";
    EXPECT_NEAR(twice.speed, 2 * once.speed, 0.1 * once.speed);
    EXPECT_NEAR(twice.height - once.height, stock_twice.height - stock_once.height, 0.02 * 0.3)
        << "springs push twice, gravity pulls once";
}

TEST(RaycastVehicleCalls, SecondStepInTheAirLeavesGravityToTheWorld) {
    World world;
    world.addPlane();
    DropIn car(world, {.height = 20});
    for (int frame = 0; frame < 60; ++frame) {
        run(world, 1.0 / 60, 60);
        car.vehicle->updateVehicle(scalar(1.0 / 60));
    }
    EXPECT_NEAR(20 - car.place().y(), kGravity / 2, 0.02 * kGravity) << "m, free fall of a second";
}

// By hand only: the world knows no vehicle.
TEST(RaycastVehicleCalls, StepByHandIsTheSameAsTheWorlds) {
    World world, by_hand_world;
    world.addPlane();
    by_hand_world.addPlane();
    DropIn car(world, {.speed = 20}), by_hand(by_hand_world, {.speed = 20});
    by_hand_world.dynamics.removeVehicle(by_hand.vehicle.get());
    for (int frame = 0; frame < 180; ++frame) {
        for (DropIn* each : {&car, &by_hand}) {
            each->steer(0.02);
            each->push(frame < 60 ? 3000 : 0);
            each->brake(frame < 120 ? 0 : 30);
        }
        run(world, 1.0 / 60, 60);
        run(by_hand_world, 1.0 / 60, 60);
        by_hand.vehicle->updateVehicle(scalar(1.0 / 60));
    }
    EXPECT_NEAR((car.place() - by_hand.place()).length(), 0, 0.02) << "of 60 m; rays are Bullet's";
}

// ---- Derived classes ----

// As a game wrote it for the stock vehicle; only the base class is another one.
class Counting : public RaycastVehicle {
public:
    using RaycastVehicle::RaycastVehicle;
    void updateVehicle(btScalar step) override {
        ++steps;
        btRaycastVehicle::updateVehicle(step);
    }
    int steps = 0;
};
class FullyQualified : public RaycastVehicle {
public:
    using RaycastVehicle::RaycastVehicle;
    void updateVehicle(btScalar step) override { ::btRaycastVehicle::updateVehicle(step); }
};

template <class Vehicle>
btVector3 placeAfterADrive() {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.friction = 0.8, .speed = 15});
    for (int frame = 0; frame < 240; ++frame) {
        car.steer(frame < 60 ? 0 : 0.1);
        car.push(frame < 120 ? 6000 : 0);
        car.brake(frame < 180 ? 0 : 200);
        run(world, 1.0 / 60, 60);
    }
    return car.place();
}

TEST(RaycastVehicleCalls, StocksStepReachesTreadFromADerivedClass) {
    const btVector3 tread = placeAfterADrive<RaycastVehicle>();
    const btVector3 stock = placeAfterADrive<btRaycastVehicle>();
    EXPECT_EQ((placeAfterADrive<Counting>() - tread).length(), 0);
    EXPECT_LT((placeAfterADrive<FullyQualified>() - tread).length(), 0.01);
    EXPECT_GT((stock - tread).length(), 5) << "the drive tells them apart";
}

TEST(RaycastVehicleCalls, WorldCallsTheOverriddenStep) {
    World world;
    world.addPlane();
    Car<Counting> car(world);
    run(world, 1, 60);
    EXPECT_EQ(car.vehicle->steps, 60);
}

// ---- Callbacks that throw ----

TEST(RaycastVehicleCalls, ThrowingSurfaceLeavesTheCarAsItWas) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 20});
    car.steer(0.05);
    bool throws = false;
    car.vehicle->setSurface([&](const SurfaceQuery& query) {
        if (throws && query.wheel == 2) throw std::runtime_error("no such material");
        return Surface{};
    });
    run(world, 2, 60);
    const double height = car.place().y();
    std::array<WheelTelemetry, 4> before, after;
    for (int i = 0; i < 4; ++i) before[static_cast<std::size_t>(i)] = car.vehicle->telemetry(i);
    throws = true;
    EXPECT_THROW(run(world, 1.0 / 60, 60), std::runtime_error);
    for (int i = 0; i < 4; ++i) after[static_cast<std::size_t>(i)] = car.vehicle->telemetry(i);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(before[i].load, after[i].load);
        EXPECT_EQ(before[i].fy, after[i].fy);
        EXPECT_EQ(before[i].spin, after[i].spin);
        EXPECT_EQ(before[i].compression, after[i].compression);
    }
    throws = false;
    double lowest = height, highest = height;
    for (int i = 0; i < 60; ++i) {
        run(world, 1.0 / 60, 60);
        lowest = std::min(lowest, static_cast<double>(car.place().y()));
        highest = std::max(highest, static_cast<double>(car.place().y()));
    }
    // It fell freely for 1/60 s, with the gravity of two steps, since Bullet has not cleared its forces when a step
    // throws; what that gave it swings on springs of four times 40 N/m per kg.
    const double swing = 2 * kGravity / 60 / std::sqrt(4 * 40);
    EXPECT_GT(lowest, height - swing);
    EXPECT_LT(highest, height + swing);
}

// ---- Settings ----

TEST(RaycastVehicleCalls, GripScalesTheTyres) {
    for (const double grip : {0.4, 1.0, 1.8}) {
        World world;
        world.addPlane();
        DropIn car(world, {.friction = 0.5, .speed = 30});
        car.vehicle->setGrip(grip);
        run(world, 0.5, 60);
        car.brake(1000);
        run(world, 0.5, 60);
        const double before = car.velocity().z();
        run(world, 0.5, 60);
        EXPECT_NEAR((before - car.velocity().z()) / 0.5 / kGravity, lockedFriction(0.5 * grip), 0.02) << grip;
    }
}

// A wheel that spins up in the air turns the car against it: together they keep the angular momentum that they had.
TEST(RaycastVehicleCalls, WheelReactionIsOffAndCanBeTurnedOn) {
    for (const bool on : {false, true}) {
        World world;
        DropIn car(world, {.height = 100});
        car.vehicle->setWheelReaction(on);
        run(world, 0.1, 240);
        car.push(2000);
        run(world, 0.5, 240);
        double spins = 0;
        for (int i = 0; i < 4; ++i) spins += car.vehicle->telemetry(i).spin;
        const double wheel = 0.6 * 0.05 * 0.25 * 1500 * 0.3 * 0.3;  // kg m2
        const double body = 1 / static_cast<double>(car.chassis->getInvInertiaDiagLocal().x());
        EXPECT_GT(spins, 100);
        EXPECT_NEAR(car.vehicle->angularVelocity().x(), on ? -wheel * spins / body : 0, 0.01 * wheel * spins / body);
    }
}

}  // namespace
}  // namespace tread::raycast_calls_test
