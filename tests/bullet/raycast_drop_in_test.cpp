// RaycastVehicle through the eyes of a game that knows only btRaycastVehicle: what it sets, and what it reads back.

#include <gtest/gtest.h>

#include <cmath>

#include "stock_vs_tread/scene.h"

namespace tread {
namespace {

using namespace scene;
using DropIn = Car<RaycastVehicle>;

constexpr double kMass = 1500;

TEST(RaycastVehicle, StandsAsHighAsTheStockVehicleAndCarriesItsWeight) {
    World stock_world, world;
    stock_world.addPlane();
    world.addPlane();
    Car<btRaycastVehicle> stock(stock_world);
    DropIn car(world);
    run(stock_world, 5, 60);
    run(world, 5, 60);
    EXPECT_NEAR(car.place().y(), stock.place().y(), 1e-4);
    double load = 0, strut = 0;
    for (int i = 0; i < 4; ++i) {
        load += car.vehicle->telemetry(i).load;
        strut += car.vehicle->getWheelInfo(i).m_wheelsSuspensionForce;
    }
    EXPECT_NEAR(load, kMass * kGravity, 1e-4 * kMass * kGravity);
    EXPECT_NEAR(strut, kMass * kGravity, 1e-4 * kMass * kGravity);
}

TEST(RaycastVehicle, BasePointerSeesLiveOutputs) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 10});
    btRaycastVehicle* game = car.vehicle.get();
    run(world, 1, 60);
    const double turned = game->getWheelInfo(2).m_rotation, from = car.place().z();
    run(world, 1, 60);
    const double gone = static_cast<double>(car.place().z()) - from;
    const btWheelInfo& wheel = game->getWheelInfo(2);
    const double slower = 0.5 * 0.01 * kGravity;  // m/s, by rolling resistance from the middle of that second on
    EXPECT_NEAR(game->getCurrentSpeedKmHour(), 3.6 * (gone - slower), 0.05);
    EXPECT_NEAR(wheel.m_rotation - turned, gone / 0.2928, 0.2) << "rolling radius 0.976 of 0.3 m";
    EXPECT_NEAR(wheel.m_deltaRotation, (wheel.m_rotation - turned) / 60, 0.01);
    EXPECT_TRUE(wheel.m_raycastInfo.m_isInContact);
    EXPECT_NE(wheel.m_raycastInfo.m_groundObject, nullptr);
    EXPECT_NEAR(wheel.m_raycastInfo.m_contactPointWS.y(), 0, 1e-4);
    EXPECT_NEAR(wheel.m_raycastInfo.m_contactNormalWS.y(), 1, 1e-6);
    EXPECT_NEAR(wheel.m_skidInfo, 1, 1e-9);
    game->updateWheelTransform(2, true);
    const btVector3 centre = game->getWheelTransformWS(2).getOrigin();
    EXPECT_NEAR(centre.z(), car.place().z() - 1.35, 1e-3);
    EXPECT_NEAR(centre.y(), 0.3 - car.vehicle->telemetry(2).deflection, 1e-3);
}

TEST(RaycastVehicle, SteersToTheSideThatTheStockVehicleDoes) {
    World stock_world, world;
    stock_world.addPlane();
    world.addPlane();
    Car<btRaycastVehicle> stock(stock_world, {.speed = 10});
    DropIn car(world, {.speed = 10});
    stock.steer(0.05);
    car.steer(0.05);
    run(stock_world, 2, 60);
    run(world, 2, 60);
    // Slow cars go where their wheels point: speed times angle over wheelbase.
    EXPECT_NEAR(stock.yawRate(), 10 * 0.05 / 2.7, 0.03);
    EXPECT_NEAR(car.yawRate(), 10 * 0.05 / 2.7, 0.03);
    EXPECT_EQ(car.vehicle->getSteeringValue(0), scalar(0.05));
}

TEST(RaycastVehicle, EngineForceIsNewtonsAtTheGround) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 5});
    run(world, 1, 60);
    car.push(3000);
    run(world, 0.5, 60);
    const double before = car.velocity().z();
    run(world, 1, 60);
    // The torque is force times radius; the wheels' inertia takes a few percent, rolling resistance 1 % of the weight.
    const double expected = (3000 - 0.01 * kMass * kGravity) / kMass;
    EXPECT_NEAR(car.velocity().z() - before, expected, 0.06 * expected);
}

TEST(RaycastVehicle, BrakeIsTheForceOfTheStockImpulseAtSixtyHertz) {
    for (double rate : {30.0, 60.0, 250.0}) {
        World world;
        world.addPlane();
        DropIn car(world, {.speed = 30});
        run(world, 1, rate);
        car.brake(20);
        run(world, 0.5, rate);
        const double before = car.velocity().z();
        run(world, 1, rate);
        const double expected = (4 * 20 * 60 + 0.01 * kMass * kGravity) / kMass;
        EXPECT_NEAR(before - car.velocity().z(), expected, 0.06 * expected) << rate << " Hz";
    }
}

TEST(RaycastVehicle, ResetSuspensionAndTeleportLeaveNoForceBehind) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 20});
    car.steer(0.1);
    run(world, 1, 60);
    car.steer(0);
    car.chassis->setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), vector(1000, 0.5387, -500)));
    car.chassis->setLinearVelocity(vector(0, 0, 0));
    car.chassis->setAngularVelocity(vector(0, 0, 0));
    car.vehicle->resetSuspension();
    run(world, 2, 60);
    EXPECT_NEAR(car.place().x(), 1000, 0.02);
    EXPECT_NEAR(car.place().z(), -500, 0.02);
    EXPECT_NEAR(car.place().y(), 0.5387, 1e-3);
    EXPECT_LT(std::abs(car.yawRate()), 1e-3);
}

TEST(RaycastVehicle, TwelveAndThreeWheelsStandAndDrive) {
    for (int wheels : {3, 5, 6, 8, 10, 12}) {
        World world;
        world.addPlane();
        btBoxShape shape(vector(1, 0.3, 3));
        btVector3 inertia;
        shape.calculateLocalInertia(scalar(kMass), inertia);
        btRigidBody chassis(scalar(kMass), nullptr, &shape, inertia);
        chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, 0.6, 0)));
        world.dynamics.addRigidBody(&chassis);
        btRaycastVehicle::btVehicleTuning tuning;
        tuning.m_suspensionStiffness = scalar(160.0 / wheels);
        tuning.m_suspensionCompression = tuning.m_suspensionDamping = 4;
        btDefaultVehicleRaycaster raycaster(&world.dynamics);
        RaycastVehicle vehicle(tuning, &chassis, &raycaster);
        world.dynamics.addVehicle(&vehicle);
        vehicle.setCoordinateSystem(0, 1, 2);
        for (int i = 0; i < wheels; ++i) {
            // Around an ellipse, symmetric to the length.
            const double angle = 2 * std::acos(-1.0) * i / wheels;
            vehicle.addWheel(vector(std::sin(angle), 0, 2.5 * std::cos(angle)), vector(0, -1, 0), vector(-1, 0, 0),
                             scalar(0.3), scalar(0.3), tuning, i == 0);
            vehicle.applyEngineForce(scalar(3000.0 / wheels), i);
        }
        run(world, 3, 60);
        const double expected = 0.5 * (3000 - 0.01 * kMass * kGravity) / kMass * 9;
        EXPECT_NEAR(chassis.getCenterOfMassPosition().z(), expected, 0.15 * expected) << wheels << " wheels";
        EXPECT_NEAR(chassis.getCenterOfMassPosition().x(), 0, 0.01) << wheels << " wheels";
        double load = 0;
        for (int i = 0; i < wheels; ++i) load += vehicle.telemetry(i).load;
        EXPECT_NEAR(load, kMass * kGravity, 0.02 * kMass * kGravity) << wheels << " wheels";
        world.dynamics.removeVehicle(&vehicle);
        world.dynamics.removeRigidBody(&chassis);
    }
}

// A game that draws at an uneven pace and steps as long as the last picture took.
TEST(RaycastVehicle, ParkedCarDoesNotMindUnevenSteps) {
    World world;
    world.addPlane();
    DropIn car(world);
    car.brake(50);
    run(world, 3, 60);
    const btVector3 before = car.place();
    for (int i = 0; i < 300; ++i) world.dynamics.stepSimulation(scalar(0.01 + 0.007 * (i % 4)), 0);
    EXPECT_LT((car.place() - before).length(), 2e-5);
}

// A raycaster that a game wrote for itself: flat ground at a height, and a handle that is no body.
struct OwnGround : btVehicleRaycaster {
    void* castRay(const btVector3& from, const btVector3& to, btVehicleRaycasterResult& result) override {
        ++asked;
        longest = (to - from).length();
        const btScalar fraction = (from.y() - height) / (from.y() - to.y());
        if (fraction < 0 || fraction > 1) return nullptr;
        result.m_distFraction = fraction;
        result.m_hitPointInWorld = from.lerp(to, fraction);
        result.m_hitNormalInWorld = btVector3(0, 1, 0);
        return &asked;
    }
    btScalar height = 1;
    btScalar longest = 0;
    int asked = 0;
};

TEST(RaycastVehicle, UsersRaycasterIsAskedForTheStockRayAndNeverTakenForABody) {
    World world;
    btBoxShape shape(vector(0.8, 0.25, 2));
    btVector3 inertia;
    shape.calculateLocalInertia(scalar(kMass), inertia);
    btRigidBody chassis(scalar(kMass), nullptr, &shape, inertia);
    chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, 1.54, 0)));
    world.dynamics.addRigidBody(&chassis);
    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = 40;
    tuning.m_suspensionCompression = tuning.m_suspensionDamping = 4;
    OwnGround raycaster;
    RaycastVehicle vehicle(tuning, &chassis, &raycaster);
    for (int i = 0; i < 4; ++i)
        vehicle.addWheel(vector(i % 2 ? -0.75 : 0.75, 0, i < 2 ? 1.35 : -1.35), vector(0, -1, 0), vector(-1, 0, 0),
                         scalar(0.3), scalar(0.3), tuning, i < 2);
    world.dynamics.addVehicle(&vehicle);
    run(world, 4, 60);
    EXPECT_NEAR(chassis.getCenterOfMassPosition().y(), 1.5387, 1e-3);
    EXPECT_GT(raycaster.asked, 4 * 30);
    EXPECT_NEAR(raycaster.longest, 0.6, 1e-5) << "rest length and radius";
    EXPECT_EQ(vehicle.getWheelInfo(0).m_raycastInfo.m_groundObject, &raycaster.asked);
    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
}

}  // namespace
}  // namespace tread
