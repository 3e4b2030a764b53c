// A Bullet world with one body and nothing else: the ground is the scenario's road.
#pragma once

#include <btBulletDynamicsCommon.h>

#include "tread/vehicle.h"

namespace tread {

// Space with nothing in it to touch, and nobody who looks at it between two steps: what Bullet would prepare for either
// is left out. Bodies have no damping.
class EmptySpace final : public btDiscreteDynamicsWorld {
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
    void predictUnconstraintMotion(btScalar) override {}
    void createPredictiveContacts(btScalar) override {}
    void performDiscreteCollisionDetection() override {}
};

class World {
public:
    explicit World(const VehicleParams& vehicle);

    btRigidBody& chassis() { return chassis_; }
    void step(double dt) { dynamics_.stepSimulation(dt, 0); }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btSimpleBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    EmptySpace dynamics_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btBoxShape shape_;
    btRigidBody chassis_;
};

}  // namespace tread
