// A game in C++17 that knows Bullet and the drop-in alone: a box on four wheels stands on a plane for a second.
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

    constexpr btScalar kMass = 1200;  // kg
    btBoxShape box(btVector3(2, btScalar(0.8), btScalar(0.3)));
    btVector3 inertia;
    box.calculateLocalInertia(kMass, inertia);
    btRigidBody chassis(btRigidBody::btRigidBodyConstructionInfo(kMass, nullptr, &box, inertia));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, btScalar(0.9))));
    world.addRigidBody(&chassis);

    btRaycastVehicle::btVehicleTuning tuning;
    btDefaultVehicleRaycaster raycaster(&world);
    tread::RaycastVehicle vehicle(tuning, &chassis, &raycaster);
    vehicle.setCoordinateSystem(1, 2, 0);
    for (const btScalar x : {btScalar(1.3), btScalar(-1.3)}) {
        for (const btScalar y : {btScalar(0.7), btScalar(-0.7)}) {
            vehicle.addWheel(btVector3(x, y, 0), btVector3(0, 0, -1), btVector3(0, 1, 0), btScalar(0.3), btScalar(0.3),
                             tuning, x > 0);
        }
    }
    tread::RaycastFleet fleet;
    fleet.add(vehicle);
    world.addAction(&fleet);
    for (int step = 0; step < 60; ++step) world.stepSimulation(btScalar(1) / 60, 0);

    // It stands: on the struts, neither on its belly (0.3 m) nor as it was dropped.
    const double height = chassis.getCenterOfMassPosition().z();
    const bool stands = height > 0.4 && height < 0.9 && std::fabs(chassis.getLinearVelocity().z()) < 0.5;
    std::printf("height %.3f m%s\n", height, stands ? "" : ", expected 0.4 to 0.9 m at rest");
    world.removeAction(&fleet);
    world.removeRigidBody(&chassis);
    world.removeRigidBody(&ground);
    return stands ? 0 : 1;
}
