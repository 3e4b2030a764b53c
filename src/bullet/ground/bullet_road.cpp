#include "tread/bullet_road.h"

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bullet/convert.h"
#include "bullet/ground/ground_below.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

constexpr double kRayAbove = 0.5;  // m above the wheel centre: a wheel that is pressed below the ground still finds it

}  // namespace

BulletRoad::BulletRoad(const btCollisionWorld& world, const btCollisionObject& own_body, const Vector3& up,
                       double ray_length)
    : world_(world), own_body_(own_body), up_(up.normalized()), ray_length_(ray_length) {}

void BulletRoad::beginStep() {
    known_.fill(false);
}

RoadContact BulletRoad::contact(const Vector3& centre_W, std::size_t wheel) const {
    if (!known_[wheel]) {
        found_[wheel] = cast(centre_W);
        known_[wheel] = true;
    }
    return found_[wheel];
}

RoadContact BulletRoad::cast(const Vector3& centre_W) const {
    const btVector3 from = toBullet(Vector3(centre_W + kRayAbove * up_));
    const btVector3 to = toBullet(Vector3(centre_W - ray_length_ * up_));
    GroundBelow ground(from, to, own_body_);
    world_.rayTest(from, to, ground);

    RoadContact contact;
    contact.exists = ground.hasHit();
    if (!contact.exists) {
        contact.point_W = centre_W - ray_length_ * up_;
        contact.normal_W = up_;
        return contact;
    }
    // Depth along the ray in double: the hit point itself is rounded to the world's precision.
    const double way = (kRayAbove + ray_length_) * static_cast<double>(ground.m_closestHitFraction);
    contact.point_W = centre_W + (kRayAbove - way) * up_;
    contact.normal_W = fromBullet(ground.m_hitNormalWorld).normalized();
    if (contact.normal_W.dot(up_) < 0) contact.normal_W = -contact.normal_W;
    if (const auto* body = btRigidBody::upcast(ground.m_collisionObject)) {
        const btVector3 arm = ground.m_hitPointWorld - body->getCenterOfMassPosition();
        contact.velocity_W = fromBullet(body->getVelocityInLocalPoint(arm));
    }
    contact.friction = 1;
    return contact;
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
