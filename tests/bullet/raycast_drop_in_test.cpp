// RaycastVehicle through the eyes of a game that knows only btRaycastVehicle: what it sets, and what it reads back.

#include <gtest/gtest.h>

#include <cmath>

#include "stock_vs_tread/scene.h"

namespace tread::raycast_drop_in_test {
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

}  // namespace
}  // namespace tread::raycast_drop_in_test
