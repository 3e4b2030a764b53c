// Any number of wheels, any axes, any raycaster.

#include <gtest/gtest.h>

#include <cmath>

#include "stock_vs_tread/scene.h"

namespace tread::raycast_layout_test {
namespace {

using namespace scene;

constexpr double kMass = 1500;

TEST(RaycastVehicleLayout, TwelveAndThreeWheelsStandAndDrive) {
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

// Every way to lay the axes: right, up and forward of the chassis along any of x, y and z.
TEST(RaycastVehicleLayout, DrivesForwardWhicheverAxesTheGameHas) {
    for (int up = 0; up < 3; ++up) {
        for (int forward = 0; forward < 3; ++forward) {
            if (forward == up) continue;
            const int right = 3 - up - forward;
            btVector3 u(0, 0, 0), f(0, 0, 0);
            u[up] = f[forward] = 1;
            const btVector3 r = f.cross(u);
            World world;
            world.add(std::make_unique<btStaticPlaneShape>(u, scalar(0)));
            world.dynamics.setGravity(scalar(-kGravity) * u);
            btVector3 half = scalar(0.25) * u + scalar(2) * f + scalar(0.8) * r;
            btBoxShape shape(half.absolute());
            btVector3 inertia;
            shape.calculateLocalInertia(scalar(kMass), inertia);
            btRigidBody chassis(scalar(kMass), nullptr, &shape, inertia);
            chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), scalar(0.54) * u));
            world.dynamics.addRigidBody(&chassis);
            btRaycastVehicle::btVehicleTuning tuning;
            tuning.m_suspensionStiffness = 40;
            tuning.m_suspensionCompression = tuning.m_suspensionDamping = 4;
            btDefaultVehicleRaycaster raycaster(&world.dynamics);
            RaycastVehicle vehicle(tuning, &chassis, &raycaster);
            world.dynamics.addVehicle(&vehicle);
            vehicle.setCoordinateSystem(right, up, forward);
            for (int i = 0; i < 4; ++i) {
                const btVector3 at = scalar(i < 2 ? 1.35 : -1.35) * f + scalar(i % 2 ? 0.75 : -0.75) * r;
                vehicle.addWheel(at, -u, r, scalar(0.3), scalar(0.3), tuning, i < 2);
                vehicle.applyEngineForce(1000, i);
                vehicle.setSteeringValue(scalar(i < 2 ? 0.02 : 0), i);
            }
            run(world, 3, 60);
            EXPECT_GT(chassis.getCenterOfMassPosition().dot(f), 11) << "up " << up << ", forward " << forward;
            EXPECT_LT(chassis.getCenterOfMassPosition().dot(r), -0.2) << "steered to the left";
            EXPECT_NEAR(chassis.getCenterOfMassPosition().dot(u), 0.5387, 0.002);
            EXPECT_NEAR(vehicle.getCurrentSpeedKmHour(), 3.6 * vehicle.velocity().length(), 0.5) << "and positive";
            EXPECT_GT(vehicle.getWheelInfo(0).m_rotation, 30);
            world.dynamics.removeVehicle(&vehicle);
            world.dynamics.removeRigidBody(&chassis);
        }
    }
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

TEST(RaycastVehicleLayout, UsersRaycasterIsAskedForTheStockRayAndNeverTakenForABody) {
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
}  // namespace tread::raycast_layout_test
