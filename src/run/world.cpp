#include "run/world.h"

namespace tread {
namespace {

constexpr double kBodyHeight = 0.6;  // m, of the box that stands for the body; nothing touches it in this world

// Room for the contacts of one body, in place of a whole scene's, which would be cleared for every run.
btDefaultCollisionConstructionInfo roomForOneBody() {
    btDefaultCollisionConstructionInfo info;
    info.m_defaultMaxPersistentManifoldPoolSize = 1;
    info.m_defaultMaxCollisionAlgorithmPoolSize = 1;
    return info;
}

}  // namespace

World::World(const VehicleParams& vehicle)
    : configuration_(roomForOneBody()),
      shape_(btVector3(0.5 * vehicle.wheelbase, 0.5 * vehicle.front.track, 0.5 * kBodyHeight)),
      chassis_(vehicle.mass, nullptr, &shape_) {
    dynamics_.setGravity(btVector3(0, 0, -kStandardGravity));
    chassis_.setActivationState(DISABLE_DEACTIVATION);
    dynamics_.addRigidBody(&chassis_);
}

}  // namespace tread
