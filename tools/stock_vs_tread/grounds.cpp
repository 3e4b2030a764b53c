// What a car may stand on: platforms, planks, triggers, ground of the game's own collision groups.
#include <cmath>

#include "problems.h"
#include "scene.h"

namespace problems {
namespace {

using namespace scene;

// Metres that a braked car goes with a platform that moves 5 m in 5 s.
template <class Vehicle>
double ride() {
    World world;
    btRigidBody& platform = world.addBox(20, 0.5, 20, 0, vector(0, -0.5, 0));
    platform.setCollisionFlags(platform.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    platform.setActivationState(DISABLE_DEACTIVATION);
    Car<Vehicle> car(world);
    car.brake(100);
    run(world, 2, 60);
    const btVector3 before = car.place();
    for (int i = 1; i <= 300; ++i) {
        platform.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(i / 60.0, -0.5, 0)));
        run(world, 1.0 / 60, 60);
    }
    run(world, 1, 60);
    return static_cast<double>((car.place() - before).x());
}

// A plank of the car's weight floats under it: its share of the momentum that gravity gives the car in half a second.
template <class Vehicle>
double reaction() {
    World world;
    btRigidBody& plank = world.addBox(5, 0.1, 5, 1500, vector(0, -0.1, 0));
    plank.setGravity(vector(0, 0, 0));
    plank.setActivationState(DISABLE_DEACTIVATION);
    plank.setDamping(0, 0);
    Car<Vehicle> car(world);
    run(world, 0.5, 60);
    const double given = -kGravity * 0.5;
    // Bullet shows the car without what gravity does in the next step.
    return static_cast<double>(plank.getLinearVelocity().y()) / given;
}

// Millimetres that a parked car sinks where a trigger volume reaches 5 cm above the ground.
template <class Vehicle>
double trigger() {
    World world;
    world.addPlane();
    Car<Vehicle> car(world);
    run(world, 2, 60);
    const double before = car.place().y();
    btBoxShape shape(vector(5, 0.05, 5));
    btCollisionObject ghost;
    ghost.setCollisionShape(&shape);
    ghost.setCollisionFlags(ghost.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    world.dynamics.addCollisionObject(&ghost);
    run(world, 2, 60);
    world.dynamics.removeCollisionObject(&ghost);
    return 1000 * (before - static_cast<double>(car.place().y()));
}

// Height of a car on ground that collides with the car's own group only. Its rays can be told so; the stock vehicle's
// cannot.
template <class Vehicle>
double group() {
    constexpr int kCars = 64, kGround = 128;
    World world;
    auto shape = std::make_unique<btStaticPlaneShape>(vector(0, 1, 0), scalar(0));
    btRigidBody ground(0, nullptr, shape.get());
    world.dynamics.addRigidBody(&ground, kGround, kCars);
    Car<Vehicle> car(world);
    if constexpr (std::is_same_v<Vehicle, tread::RaycastVehicle>) car.vehicle->setCollisionFilter(kCars, kGround);
    world.dynamics.removeRigidBody(car.chassis.get());
    world.dynamics.addRigidBody(car.chassis.get(), kCars, kGround);
    run(world, 3, 60);
    world.dynamics.removeRigidBody(&ground);
    return car.place().y();
}

}  // namespace

void grounds(Rows& rows) {
    using Stock = btRaycastVehicle;
    using Tread = tread::RaycastVehicle;
    rows.push_back({"platform moves 5 m: the car on it moves", ride<Stock>(), ride<Tread>(), "m", 4.95, 5.05});
    rows.push_back(
        {"floating plank of the car's mass: speed over g t", reaction<Stock>(), reaction<Tread>(), "-", 0.4, 0.6});
    rows.push_back(
        {"trigger volume 5 cm above the ground: the car sinks", trigger<Stock>(), trigger<Tread>(), "mm", -0.1, 0.1});
    rows.push_back({"ground with a collision group of its own: height of the car (0.54 when it stands)", group<Stock>(),
                    group<Tread>(), "m", 0.53, 0.55});
}

}  // namespace problems
