// A Bullet world with one body and nothing else: the ground is the scenario's road.
#pragma once

#include <btBulletDynamicsCommon.h>

#include "tread/vehicle.h"

namespace tread {

class World {
public:
    explicit World(const VehicleParams& vehicle);

    btRigidBody& chassis() { return chassis_; }
    Vector3 gravity() const { return {0, 0, -kStandardGravity}; }
    void step(double dt) { dynamics_.stepSimulation(dt, 0); }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btSimpleBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld dynamics_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btBoxShape shape_;
    btRigidBody chassis_;
};

}  // namespace tread
