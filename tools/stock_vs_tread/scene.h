// A game's world and car as Bullet's demos set them up (y up, z forward), with the stock vehicle or with tread's.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <type_traits>
#include <vector>

#include "tread/raycast_vehicle.h"

namespace scene {

inline btScalar scalar(double x) {
    return static_cast<btScalar>(x);
}
inline btVector3 vector(double x, double y, double z) {
    return {scalar(x), scalar(y), scalar(z)};
}

// Two triangles for each cell of a grid, whose points are at(i, j): facing up where i goes along x and j along z.
template <class At>
void addGrid(btTriangleMesh& mesh, int across, int along, const At& at) {
    for (int j = 0; j + 1 < along; ++j) {
        for (int i = 0; i + 1 < across; ++i) {
            mesh.addTriangle(at(i, j), at(i, j + 1), at(i + 1, j));
            mesh.addTriangle(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
        }
    }
}

constexpr double kGravity = 9.81;  // m/s2

class World {
public:
    World() { dynamics.setGravity(vector(0, -kGravity, 0)); }
    ~World() {
        for (auto& body : bodies_) dynamics.removeCollisionObject(body.get());
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // A body that the world keeps; without mass it does not move.
    template <class Shape>
    btRigidBody& add(std::unique_ptr<Shape> shape, double mass = 0, const btVector3& at = vector(0, 0, 0)) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(scalar(mass), inertia);
        bodies_.push_back(std::make_unique<btRigidBody>(scalar(mass), nullptr, shape.get(), inertia));
        shapes_.push_back(std::move(shape));
        bodies_.back()->setWorldTransform(btTransform(btQuaternion::getIdentity(), at));
        dynamics.addRigidBody(bodies_.back().get());
        return *bodies_.back();
    }
    btRigidBody& addPlane() { return add(std::make_unique<btStaticPlaneShape>(vector(0, 1, 0), scalar(0))); }
    btRigidBody& addBox(double x, double y, double z, double mass, const btVector3& at) {
        return add(std::make_unique<btBoxShape>(vector(x, y, z)), mass, at);
    }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;

public:
    btDiscreteDynamicsWorld dynamics{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

struct Setup {
    double friction = 1;
    double stiffness = 40;  // times mass: N/m
    double damping = 4.4;   // times mass: N s/m
    double roll_influence = 0.1;
    double height = 0.54;     // m, of the centre of gravity at rest
    double most_force = 1e5;  // N
    double speed = 0;         // m/s, forward
    double substep = 0;       // s, tread's; 0: its own
    bool sleeps = false;
    btTransform place = btTransform::getIdentity();  // turns and moves car and heading
};

// 1500 kg, wheelbase 2.7 m, track 1.5 m, springs of 60 kN/m. Wheels: front left, front right, rear left, rear right.
template <class Vehicle>
class Car {
public:
    explicit Car(World& world, const Setup& setup = {}) : world_(world), raycaster_(&world.dynamics) {
        constexpr double kMass = 1500;
        btVector3 inertia;
        shape_.calculateLocalInertia(scalar(kMass), inertia);
        chassis = std::make_unique<btRigidBody>(scalar(kMass), nullptr, &shape_, inertia);
        chassis->setWorldTransform(setup.place * btTransform(btQuaternion::getIdentity(), vector(0, setup.height, 0)));
        chassis->setLinearVelocity(setup.place.getBasis() * vector(0, 0, setup.speed));
        if (!setup.sleeps) chassis->setActivationState(DISABLE_DEACTIVATION);
        world.dynamics.addRigidBody(chassis.get());

        btRaycastVehicle::btVehicleTuning tuning;
        tuning.m_suspensionStiffness = scalar(setup.stiffness);
        tuning.m_suspensionCompression = tuning.m_suspensionDamping = scalar(setup.damping);
        tuning.m_frictionSlip = scalar(setup.friction);
        tuning.m_maxSuspensionForce = scalar(setup.most_force);
        vehicle = std::make_unique<Vehicle>(tuning, chassis.get(), &raycaster_);
        world.dynamics.addVehicle(vehicle.get());
        vehicle->setCoordinateSystem(0, 1, 2);
        for (int i = 0; i < 4; ++i) {
            const bool front = i < 2;
            const btVector3 at = vector(i % 2 == 0 ? 0.75 : -0.75, 0, front ? 1.35 : -1.35);
            btWheelInfo& wheel =
                vehicle->addWheel(at, vector(0, -1, 0), vector(-1, 0, 0), scalar(0.3), scalar(0.3), tuning, front);
            wheel.m_rollInfluence = scalar(setup.roll_influence);
        }
        if constexpr (std::is_base_of_v<tread::RaycastVehicle, Vehicle>) {
            if (setup.substep > 0) vehicle->setSubstep(setup.substep);
        }
    }
    ~Car() {
        world_.dynamics.removeVehicle(vehicle.get());
        world_.dynamics.removeRigidBody(chassis.get());
    }
    Car(const Car&) = delete;
    Car& operator=(const Car&) = delete;

    void steer(double angle) {
        for (int i : {0, 1}) vehicle->setSteeringValue(scalar(angle), i);
    }
    void brake(double impulse) {
        for (int i = 0; i < 4; ++i) vehicle->setBrake(scalar(impulse), i);
    }
    void push(double force) {
        for (int i = 0; i < 4; ++i) vehicle->applyEngineForce(scalar(0.25 * force), i);
    }
    btVector3 place() const { return chassis->getCenterOfMassPosition(); }
    btVector3 velocity() const { return chassis->getLinearVelocity(); }
    double yawRate() const { return chassis->getAngularVelocity().y(); }

private:
    World& world_;
    btBoxShape shape_{vector(0.8, 0.25, 2)};
    btDefaultVehicleRaycaster raycaster_;

public:
    std::unique_ptr<btRigidBody> chassis;
    std::unique_ptr<Vehicle> vehicle;
};

// Steps as a game does that draws `rate` pictures a second.
inline void run(World& world, double seconds, double rate) {
    const auto steps = static_cast<int>(seconds * rate + 0.5);
    for (int i = 0; i < steps; ++i) world.dynamics.stepSimulation(scalar(1 / rate), 0);
}

}  // namespace scene
