// A game in C++17 that knows Bullet and the drop-in alone: a box on four wheels comes to stand on a plane.
#include <btBulletDynamicsCommon.h>
#include <tread/raycast_fleet.h>
#include <tread/raycast_vehicle.h>

#include <cmath>
#include <cstdio>

static_assert(__cplusplus == 201703L, "tread asks for a newer C++ than this game's");

int main() {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(btVector3(0, 0, btScalar(-9.81)));
    btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
    btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
    world.addRigidBody(&ground);

    constexpr btScalar kMass = 1200;        // kg
    constexpr btScalar kRadius = 0.3f;      // m
    constexpr btScalar kRestLength = 0.3f;  // m
    btBoxShape box(btVector3(2, btScalar(0.8), btScalar(0.3)));
    btVector3 inertia;
    box.calculateLocalInertia(kMass, inertia);
    btRigidBody chassis(btRigidBody::btRigidBodyConstructionInfo(kMass, nullptr, &box, inertia));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, btScalar(0.55))));
    world.addRigidBody(&chassis);

    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = 30;   // N/m for each kg
    tuning.m_suspensionDamping = 4;      // N s/m for each kg
    tuning.m_suspensionCompression = 4;  // N s/m for each kg
    btDefaultVehicleRaycaster raycaster(&world);
    tread::RaycastVehicle vehicle(tuning, &chassis, &raycaster);
    vehicle.setCoordinateSystem(1, 2, 0);
    for (const btScalar x : {btScalar(1.3), btScalar(-1.3)}) {
        for (const btScalar y : {btScalar(0.7), btScalar(-0.7)}) {
            vehicle.addWheel(btVector3(x, y, 0), btVector3(0, 0, -1), btVector3(0, 1, 0), kRestLength, kRadius, tuning,
                             x > 0);
        }
    }
    tread::RaycastFleet fleet;
    fleet.add(vehicle);
    world.addAction(&fleet);
    for (int step = 0; step < 180; ++step) world.stepSimulation(btScalar(1) / 60, 0);

    // Four springs carry it.
    const double expected = kRestLength - 9.81 / (4 * tuning.m_suspensionStiffness) + kRadius;
    const double height = chassis.getCenterOfMassPosition().z();
    const bool stands = std::fabs(height - expected) < 0.01;
    std::printf("height %.4f m, expected %.4f m%s\n", height, expected, stands ? "" : "  <-- WRONG");
    world.removeAction(&fleet);
    world.removeRigidBody(&chassis);
    world.removeRigidBody(&ground);
    return stands ? 0 : 1;
}
