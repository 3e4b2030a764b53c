// Bullet's own step of the vehicle, where a game still calls it: ::btRaycastVehicle::updateVehicle by its full name.
// Its suspension has pushed when it comes to friction, the one part that it asks of the derived class.
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>

#include "bullet/drop_in/raycast_parts.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

void RaycastVehicle::updateFriction(btScalar step) {
    if (self_->showing_speed) return;
    self_->takeBackStock(step);
    self_->step(self_->world, step);
}

btScalar RaycastVehicle::rayCast(btWheelInfo& wheel) {
    return ::btRaycastVehicle::rayCast(wheel);
}

void RaycastVehicle::updateSuspension(btScalar step) {
    ::btRaycastVehicle::updateSuspension(step);
}

void RaycastVehicle::Implementation::takeBackStock(double dt) {
    for (std::size_t i = 0; i < wheelCount(); ++i) {
        btWheelInfo& wheel = info(i);
        const btWheelInfo::RaycastInfo& ray = wheel.m_raycastInfo;
        const btScalar force = std::min(wheel.m_wheelsSuspensionForce, wheel.m_maxSuspensionForce);
        const btVector3 impulse = ray.m_contactNormalWS * force * static_cast<btScalar>(dt);
        chassis.applyImpulse(-impulse, ray.m_contactPointWS - chassis.getCenterOfMassPosition());
        if (i < wheels_before) wheel.m_raycastInfo.m_suspensionLength = shown_length[i];
    }
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
