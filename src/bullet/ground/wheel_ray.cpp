#include "bullet/ground/wheel_ray.h"

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cmath>
#include <optional>

#include "base/math/elementary.h"
#include "bullet/convert.h"
#include "bullet/ground/ground_search.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// Height of a rough surface: bumps about a metre long, the same whenever one comes there.
double bump(const Vector3& at, double amplitude) {
    if (amplitude == 0) return 0;
    return amplitude * (0.5 * sine(6.1 * at.x() + 2.3 * at.y() + 1.7 * at.z()) +
                        0.5 * sine(-2.9 * at.x() + 5.3 * at.y() + 3.1 * at.z() + 1));
}

// m/s: what is faster was put elsewhere. Bullet takes the way of a kinematic body within a step for its velocity, also
// that from the origin to where a game puts a new one.
constexpr double kFastestGround = 340;

// Completes a ground whose plane is known.
void describe(WheelGround& ground, const SurfaceQuery& query, SurfaceSource* surface) {
    if (surface) ground.surface = surface->at(query);
    const double friction = ground.surface.friction;
    ground.plane.friction = std::isfinite(friction) && friction > 0 ? friction : 0;
    const double roughness = std::isfinite(ground.surface.roughness) ? ground.surface.roughness : 0;
    ground.plane.point_W += bump(ground.plane.point_W, roughness) * ground.plane.normal_W;
    if (!ground.object) return;
    ground.place = ground.object->getWorldArrayIndex();
    ground.pose = ground.object->getWorldTransform();
    if (const auto* body = btRigidBody::upcast(ground.object)) {
        if (body->isStaticObject() && !body->isKinematicObject()) return;
        const Vector3 velocity =
            fromBullet(body->getVelocityInLocalPoint(query.point - body->getCenterOfMassPosition()));
        if (velocity.norm() < kFastestGround) ground.plane.velocity_W = velocity;
    }
}

bool isUnit(const Vector3& n) {
    return n.allFinite() && std::abs(n.norm() - 1) < 0.5;
}

// A user's raycaster may return anything that is not null: only what the world holds is a body.
btCollisionObject* heldBy(const btCollisionWorld* world, void* handle) {
    if (!world) return nullptr;
    const auto& objects = world->getCollisionObjectArray();
    const int place = objects.findLinearSearch(static_cast<btCollisionObject*>(handle));
    return place < objects.size() ? objects[place] : nullptr;
}

WheelGround nothingUnder(const WheelRay& ray) {
    WheelGround ground;
    ground.plane.exists = false;
    ground.cast_at = ray.top_W;
    ground.known = true;
    return ground;
}

WheelGround castByUser(const WheelRay& ray, const RaySource& source) {
    WheelGround ground = nothingUnder(ray);
    const btVector3 from = toBullet(ray.top_W), to = toBullet(Vector3(ray.top_W + ray.length * ray.down_W));
    btVehicleRaycaster::btVehicleRaycasterResult result;
    ground.handle = source.user->castRay(from, to, result);
    const Vector3 normal = fromBullet(result.m_hitNormalInWorld);
    ground.plane.exists = ground.handle && std::isfinite(result.m_distFraction) && isUnit(normal);
    if (!ground.plane.exists) return ground;
    ground.object = heldBy(source.world, ground.handle);
    ground.plane.point_W = ray.top_W + static_cast<double>(result.m_distFraction) * ray.length * ray.down_W;
    ground.plane.normal_W = normal.normalized();
    describe(ground, {ground.object, -1, -1, result.m_hitPointInWorld, ray.wheel}, source.surface);
    return ground;
}

WheelGround castIntoWorld(const WheelRay& ray, const RaySource& source) {
    WheelGround ground = nothingUnder(ray);
    const std::optional<GroundHit> hit = findGround(ray, source);
    ground.plane.exists = hit && isUnit(hit->normal_W);
    if (!ground.plane.exists) return ground;
    ground.handle = ground.object = hit->object;
    ground.plane.point_W = hit->point_W;
    ground.plane.normal_W = hit->normal_W.normalized();
    if (ground.plane.normal_W.dot(ray.down_W) > 0) ground.plane.normal_W = -ground.plane.normal_W;
    if (hit->triangle >= 0 && source.rounding.angle > 0)
        ground.plane.normal_W = smoothNormal(source.near, ground.plane.point_W, ground.plane.normal_W, source.rounding);
    const btVector3 point = toBullet(ground.plane.point_W);
    describe(ground, {ground.object, hit->part, hit->triangle, point, ray.wheel}, source.surface);
    return ground;
}

}  // namespace

btRigidBody* bodyUnder(const WheelGround& ground) {
    return ground.object ? btRigidBody::upcast(ground.object) : nullptr;
}

bool isThere(const WheelGround& ground, const btCollisionWorld& world) {
    if (!ground.object) return true;
    const auto& objects = world.getCollisionObjectArray();
    if (ground.place < 0 || ground.place >= objects.size() || objects[ground.place] != ground.object) return false;
    return ground.object->getWorldTransform() == ground.pose;
}

void lookAround(NearObjects& around, const btCollisionWorld& world, std::span<const WheelRay> rays) {
    std::optional<Box> all;
    for (const WheelRay& ray : rays) {
        if (!ray.isFinite()) continue;
        const btVector3 from = toBullet(ray.start_W()), to = toBullet(Vector3(ray.start_W() + ray.way_W()));
        if (!all) all = Box{from, from};
        all->include(from);
        all->include(to);
    }
    if (all) around.find(world, *all);
}

WheelGround castRay(const WheelRay& ray, const RaySource& source) {
    if (ray.isFinite() && source.user) return castByUser(ray, source);
    if (ray.isFinite() && source.world) return castIntoWorld(ray, source);
    return nothingUnder(ray);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
