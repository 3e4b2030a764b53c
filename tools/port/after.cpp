// A small game on Bullet's own vehicle: a van drives off, turns, brakes, and is shown once a second.
#include <btBulletDynamicsCommon.h>
#include <tread/raycast_vehicle.h>

#include <cstdio>
#include <memory>

int main() {
    // The world: a plane, y up.
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(btVector3(0, btScalar(-9.81), 0));
    btStaticPlaneShape plane(btVector3(0, 1, 0), 0);
    btRigidBody ground(0, nullptr, &plane);
    world.addRigidBody(&ground);

    // The chassis: a box above the centre of gravity.
    btBoxShape box(btVector3(btScalar(0.9), btScalar(0.5), btScalar(2.2)));
    btCompoundShape shape;
    shape.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(0.6), 0)), &box);
    const btScalar mass = 1800;
    btVector3 inertia;
    box.calculateLocalInertia(mass, inertia);
    btRigidBody chassis(mass, nullptr, &shape, inertia);
    chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(0.8), 0)));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(&chassis);

    // The vehicle.
    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = 35;
    tuning.m_suspensionCompression = btScalar(3.5);
    tuning.m_suspensionDamping = btScalar(4.5);
    btDefaultVehicleRaycaster raycaster(&world);
    std::unique_ptr<btRaycastVehicle> vehicle;
    vehicle = std::make_unique<tread::RaycastVehicle>(tuning, &chassis, &raycaster);
    vehicle->setCoordinateSystem(0, 1, 2);
    world.addVehicle(vehicle.get());
    const btVector3 down(0, -1, 0), axle(-1, 0, 0);
    for (int i = 0; i < 4; ++i) {
        const bool front = i < 2;
        const btVector3 place(i % 2 == 0 ? btScalar(0.8) : btScalar(-0.8), 0, front ? btScalar(1.5) : btScalar(-1.4));
        vehicle->addWheel(place, down, axle, btScalar(0.35), btScalar(0.34), tuning, front);
    }

    // Ten seconds at 60 Hz.
    for (int frame = 0; frame < 600; ++frame) {
        const bool gas = frame < 240, turning = frame >= 240 && frame < 360, braking = frame >= 420;
        for (int rear : {2, 3}) vehicle->applyEngineForce(gas ? 3000 : 0, rear);
        for (int front : {0, 1}) vehicle->setSteeringValue(turning ? btScalar(0.06) : 0, front);
        for (int wheel = 0; wheel < 4; ++wheel) vehicle->setBrake(braking ? 50 : 0, wheel);
        world.stepSimulation(btScalar(1) / 60, 0);
        if (frame % 60 != 59) continue;
        const btVector3 at = chassis.getCenterOfMassPosition();
        vehicle->updateWheelTransform(0, true);
        const btVector3 wheel = vehicle->getWheelTransformWS(0).getOrigin();
        std::printf("%2d s: %6.1f km/h at %6.2f %6.2f, height %5.3f, front left wheel %5.3f, skid %4.2f\n",
                    (frame + 1) / 60, static_cast<double>(vehicle->getCurrentSpeedKmHour()),
                    static_cast<double>(at.x()), static_cast<double>(at.z()), static_cast<double>(at.y()),
                    static_cast<double>(wheel.y()), static_cast<double>(vehicle->getWheelInfo(0).m_skidInfo));
    }
    world.removeVehicle(vehicle.get());
    world.removeRigidBody(&chassis);
    world.removeRigidBody(&ground);
    return 0;
}
