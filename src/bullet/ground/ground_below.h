// The closest ground under a ray of a car.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include "tread/bullet_precision.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// What group and mask let through as for any ray of Bullet's, but neither the car's own body nor a volume that only
// triggers. Refusing the own body before the exact test saves more than half of the cost of a ray that starts inside
// it.
struct GroundBelow : btCollisionWorld::ClosestRayResultCallback {
    GroundBelow(const btVector3& from, const btVector3& to, const btCollisionObject& own)
        : ClosestRayResultCallback(from, to), own_body(own) {
        // Bullet's default caster is wrong by up to half a metre on boxes in single precision.
        if constexpr (sizeof(btScalar) == sizeof(float))
            m_flags |= btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
    }
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
        return object != &own_body && object->hasContactResponse() && ClosestRayResultCallback::needsCollision(proxy);
    }
    const btCollisionObject& own_body;
};

}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
