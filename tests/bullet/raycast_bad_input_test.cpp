// What a game may do to a vehicle by mistake, and what then happens.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "stock_vs_tread/scene.h"

namespace tread::raycast_bad_input_test {
namespace {

using namespace scene;
using DropIn = Car<RaycastVehicle>;
constexpr btScalar kNaN = std::numeric_limits<btScalar>::quiet_NaN();

btTransform beside(double x) {
    return btTransform(btQuaternion::getIdentity(), vector(x, 0, 0));
}
bool finite(const btVector3& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}
bool finite(const DropIn& car) {
    return finite(car.place()) && finite(car.velocity()) && finite(car.chassis->getAngularVelocity());
}

TEST(RaycastVehicleBadInput, NullChassisIsAnException) {
    EXPECT_THROW(RaycastVehicle({}, nullptr, nullptr), std::invalid_argument);
}

TEST(RaycastVehicleBadInput, NullRaycasterUsesTheWorldOfTheAction) {
    World world;
    world.addPlane();
    btBoxShape shape(vector(0.8, 0.25, 2));
    btRigidBody chassis(1500, nullptr, &shape, vector(2000, 2500, 500));
    chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, 0.6, 0)));
    world.dynamics.addRigidBody(&chassis);
    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = 40;
    RaycastVehicle vehicle(tuning, &chassis, nullptr);
    for (int i = 0; i < 4; ++i)
        vehicle.addWheel(vector(i % 2 ? -0.75 : 0.75, 0, i < 2 ? 1.35 : -1.35), vector(0, -1, 0), vector(-1, 0, 0),
                         scalar(0.3), scalar(0.3), tuning, i < 2);
    world.dynamics.addVehicle(&vehicle);
    run(world, 3, 60);
    EXPECT_NEAR(chassis.getCenterOfMassPosition().y(), 0.5387, 0.01);
    vehicle.updateVehicle(scalar(0.01));  // by hand there is neither world nor raycaster: nothing under the wheels
    EXPECT_FALSE(vehicle.getWheelInfo(0).m_raycastInfo.m_isInContact);
    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
}

// Every number of a wheel in turn is zero, negative, huge and no number: the car stays finite and above the ground.
TEST(RaycastVehicleBadInput, ZeroNegativeHugeAndNaNTuningStaysFinite) {
    const std::vector<btScalar btWheelInfo::*> numbers{&btWheelInfo::m_suspensionRestLength1,
                                                       &btWheelInfo::m_maxSuspensionTravelCm,
                                                       &btWheelInfo::m_wheelsRadius,
                                                       &btWheelInfo::m_suspensionStiffness,
                                                       &btWheelInfo::m_wheelsDampingCompression,
                                                       &btWheelInfo::m_wheelsDampingRelaxation,
                                                       &btWheelInfo::m_frictionSlip,
                                                       &btWheelInfo::m_rollInfluence,
                                                       &btWheelInfo::m_maxSuspensionForce,
                                                       &btWheelInfo::m_steering,
                                                       &btWheelInfo::m_engineForce,
                                                       &btWheelInfo::m_brake};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        for (btScalar value : {btScalar(0), btScalar(-1), btScalar(1e30), kNaN}) {
            World world;
            world.addPlane();
            DropIn car(world, {.speed = 10});
            run(world, 0.5, 60);
            for (int k = 0; k < 4; ++k) car.vehicle->getWheelInfo(k).*numbers[i] = value;
            run(world, 2, 60);
            EXPECT_TRUE(finite(car)) << "number " << i << " is " << value;
            EXPECT_GT(car.place().y(), 0.05) << "number " << i << " is " << value;
        }
    }
}

TEST(RaycastVehicleBadInput, DirectionsWithoutLengthStayFinite) {
    for (const btVector3& direction : {vector(0, 0, 0), btVector3(kNaN, 0, 0), vector(1e30, 1e30, 0)}) {
        World world;
        world.addPlane();
        DropIn car(world);
        for (int k = 0; k < 4; ++k) {
            car.vehicle->getWheelInfo(k).m_wheelAxleCS = direction;
            if (k > 1) car.vehicle->getWheelInfo(k).m_chassisConnectionPointCS = direction * 0;
        }
        run(world, 1, 60);
        EXPECT_TRUE(finite(car));
    }
}

TEST(RaycastVehicleBadInput, WheelAddedAfterTheFirstStepCarries) {
    World world;
    world.addPlane();
    DropIn car(world);
    run(world, 1, 60);
    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = 40;
    car.vehicle->addWheel(vector(0, 0, 0), vector(0, -1, 0), vector(-1, 0, 0), scalar(0.3), scalar(0.3), tuning, false);
    run(world, 3, 60);
    EXPECT_TRUE(finite(car));
    EXPECT_NEAR(car.vehicle->telemetry(4).load, 0.2 * 1500 * kGravity, 100);
}

TEST(RaycastVehicleBadInput, WheelsBeyondTheTwelfthCarryNothing) {
    World world;
    world.addPlane();
    DropIn car(world);
    for (int i = 4; i < 20; ++i)
        car.vehicle->addWheel(vector(0, 0, 0.1 * (i - 12)), vector(0, -1, 0), vector(-1, 0, 0), scalar(0.3),
                              scalar(0.3), {}, false);
    run(world, 2, 60);
    EXPECT_TRUE(finite(car));
    EXPECT_EQ(car.vehicle->getNumWheels(), 20);
    EXPECT_EQ(car.vehicle->telemetry(15).load, 0);
}

TEST(RaycastVehicleBadInput, WorldMayGoFirst) {
    btBoxShape shape(vector(0.8, 0.25, 2));
    btRigidBody chassis(1500, nullptr, &shape, vector(2000, 2500, 500));
    std::unique_ptr<RaycastVehicle> vehicle;
    {
        World world;
        world.addPlane();
        world.dynamics.addRigidBody(&chassis);
        btDefaultVehicleRaycaster raycaster(&world.dynamics);
        vehicle = std::make_unique<RaycastVehicle>(btRaycastVehicle::btVehicleTuning(), &chassis, &raycaster);
        vehicle->addWheel(vector(0, 0, 0), vector(0, -1, 0), vector(-1, 0, 0), scalar(0.3), scalar(0.3), {}, false);
        world.dynamics.addVehicle(vehicle.get());
        run(world, 0.5, 60);
        world.dynamics.removeRigidBody(&chassis);
    }
    EXPECT_EQ(vehicle->getNumWheels(), 1);
    vehicle.reset();
}

TEST(RaycastVehicleBadInput, SecondWorldIsIgnored) {
    World world, other;
    world.addPlane();
    DropIn car(world), twin(world, {.place = beside(10)});
    other.dynamics.addAction(car.vehicle.get());
    for (DropIn* c : {&car, &twin}) c->push(3000);
    for (int i = 0; i < 60; ++i) {
        run(world, 1.0 / 60, 60);
        run(other, 1.0 / 60, 60);
    }
    EXPECT_NEAR(car.place().z(), twin.place().z(), 1e-6);
    other.dynamics.removeAction(car.vehicle.get());
}

TEST(RaycastVehicleBadInput, NothingUnderTheWheelsForMinutes) {
    World world;
    DropIn car(world);
    car.push(5000);
    car.steer(0.2);
    run(world, 180, 60);
    EXPECT_TRUE(finite(car));
    EXPECT_NEAR(car.velocity().y(), -kGravity * 180, 0.01 * kGravity * 180) << "it falls";
    EXPECT_LT(car.vehicle->telemetry(0).spin * 0.3, 201) << "m/s, of a rim in the air";
}

TEST(RaycastVehicleBadInput, MassMayChangeWhileDriving) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 10});
    run(world, 1, 60);
    car.chassis->setMassProps(3000, vector(4000, 5000, 1000));
    car.chassis->setGravity(vector(0, -kGravity, 0));
    run(world, 3, 60);
    double load = 0;
    for (int i = 0; i < 4; ++i) load += car.vehicle->telemetry(i).load;
    EXPECT_NEAR(load, 3000 * kGravity, 0.01 * 3000 * kGravity);
    car.chassis->setMassProps(0, vector(0, 0, 0));  // static from now on
    car.chassis->setLinearVelocity(vector(0, 0, 0));
    const btVector3 before = car.place();
    run(world, 1, 60);
    EXPECT_TRUE(finite(car));
    EXPECT_LT((car.place() - before).length(), 0.05);
}

TEST(RaycastVehicleBadInput, StepsOfZeroNaNAndASecond) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 10});
    run(world, 1, 60);
    const btVector3 velocity = car.velocity();
    car.vehicle->updateAction(&world.dynamics, 0);
    car.vehicle->updateAction(&world.dynamics, -1);
    car.vehicle->updateAction(&world.dynamics, kNaN);
    EXPECT_EQ((car.velocity() - velocity).length(), 0) << "no time, no effect";
    run(world, 5, 1);
    EXPECT_TRUE(finite(car));
    EXPECT_NEAR(car.place().z(), 60 - 0.5 * 0.01 * kGravity * 36, 2) << "rolling resistance takes 1 % of g";
    EXPECT_NEAR(car.place().y(), 0.5387, 0.01);
    world.dynamics.stepSimulation(100, 0);
    EXPECT_TRUE(finite(car));
}

// Bullet scales shapes, not masses: the car feels nothing of it.
TEST(RaycastVehicleBadInput, ChassisMayBeScaledWhileDriving) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 10}), twin(world, {.speed = 10, .place = beside(10)});
    run(world, 1, 60);
    for (double scale : {1.2, 0.0, 0.5}) {
        car.chassis->getCollisionShape()->setLocalScaling(vector(scale, scale, scale));
        world.dynamics.updateSingleAabb(car.chassis.get());
        run(world, 1, 60);
        EXPECT_NEAR(car.place().y(), twin.place().y(), 1e-3);
        EXPECT_NEAR(car.place().z(), twin.place().z(), 1e-3);
    }
}

// A new kinematic body comes from the origin within one step, as far as Bullet knows.
TEST(RaycastVehicleBadInput, GroundThatIsPutElsewhereDoesNotThrowTheCar) {
    World world;
    btRigidBody& platform = world.addBox(20, 0.5, 20, 0, vector(0, -0.5, 0));
    platform.setCollisionFlags(platform.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    platform.setActivationState(DISABLE_DEACTIVATION);
    platform.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(60, -0.5, 40)));
    DropIn car(world, {.place = btTransform(btQuaternion::getIdentity(), vector(60, 0, 40))});
    car.brake(50);
    run(world, 2, 60);
    EXPECT_NEAR(car.place().x(), 60, 0.01);
    EXPECT_NEAR(car.place().z(), 40, 0.01);
}

TEST(RaycastVehicleBadInput, TeleportByAKilometreKeepsTheSpeedAndNoForce) {
    World world;
    world.addPlane();
    DropIn car(world, {.speed = 20});
    car.steer(0.05);
    run(world, 1, 60);
    const double speed = car.velocity().length();
    btTransform pose = car.chassis->getCenterOfMassTransform();
    pose.setOrigin(pose.getOrigin() + vector(1000, 0, 0));
    car.chassis->setWorldTransform(pose);
    run(world, 0.5, 60);
    EXPECT_TRUE(finite(car));
    EXPECT_NEAR(car.velocity().length(), speed, 0.5);
    EXPECT_NEAR(car.place().y(), 0.5387, 0.02);
}

}  // namespace
}  // namespace tread::raycast_bad_input_test
