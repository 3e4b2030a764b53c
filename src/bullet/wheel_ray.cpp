#include "bullet/wheel_ray.h"

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bullet/convert.h"
#include "bullet/ground_below.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// Bullet makes two triangles of a plane for each ray.
std::optional<Meets> meetPlane(const btCollisionObject& object, const Way& ray) {
    const auto& [start, way] = ray;
    const auto& plane = static_cast<const btStaticPlaneShape&>(*object.getCollisionShape());
    const btTransform& pose = object.getWorldTransform();
    const Vector3 normal = fromBullet(pose.getBasis() * plane.getPlaneNormal());
    const double above =
        normal.dot(start - fromBullet(pose.getOrigin())) - static_cast<double>(plane.getPlaneConstant());
    const double goes = normal.dot(way);
    const double fraction = -above / goes;
    if (!(fraction >= 0 && fraction <= 1)) return {};
    return Meets{fraction, normal};
}

// Bullet's own answer is wrong by millimetres on large boxes, and its normal by a hundredth. Nothing when the ray
// starts inside.
std::optional<Meets> enterBox(const btCollisionObject& object, const Way& ray) {
    const auto& [start, way] = ray;
    const auto& box = static_cast<const btBoxShape&>(*object.getCollisionShape());
    const btMatrix3x3& basis = object.getWorldTransform().getBasis();
    const Vector3 half = fromBullet(box.getHalfExtentsWithMargin());
    const Vector3 from = start - fromBullet(object.getWorldTransform().getOrigin());
    double enters = -1, leaves = 2;
    Vector3 normal = Vector3::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vector3 axis = fromBullet(basis.getColumn(k)).normalized();
        const double at = from.dot(axis), goes = way.dot(axis);
        if (goes == 0) {
            if (std::abs(at) > half[k]) return {};
            continue;
        }
        const double side = goes > 0 ? -1 : 1;
        const double in = (side * half[k] - at) / goes;
        if (in > enters) {
            enters = in;
            normal = side * axis;
        }
        leaves = std::min(leaves, (-side * half[k] - at) / goes);
    }
    if (enters < 0 || enters > 1 || enters > leaves) return {};
    return Meets{enters, normal};
}

// What a user's filter lets through, with the part of a shape that was hit; planes, boxes and the faces of the mesh or
// height field on which the wheel stood last are met exactly, and without Bullet.
struct FilteredGround : GroundBelow {
    FilteredGround(const Way& r, const RaySource& s)
        : GroundBelow(toBullet(r.start_W), toBullet(Vector3(r.start_W + r.way_W)), s.chassis), ray(r), source(s) {
        m_collisionFilterGroup = source.filter.group;
        m_collisionFilterMask = source.filter.mask;
    }
    // Whether Bullet must look closer.
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
        return GroundBelow::needsCollision(proxy) && source.chassis.checkCollideWith(object) &&
               !const_cast<FilteredGround*>(this)->isDone(*object);
    }
    void askBullet(btCollisionObject& object) {
        const btTransform from(btQuaternion::getIdentity(), m_rayFromWorld),
            to(btQuaternion::getIdentity(), m_rayToWorld);
        btCollisionWorld::rayTestSingle(from, to, &object, object.getCollisionShape(), object.getWorldTransform(),
                                        *this);
    }
    bool isDone(const btCollisionObject& object) {
        const btCollisionShape& shape = *object.getCollisionShape();
        if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) take(object, meetPlane(object, ray));
        else if (shape.getShapeType() == BOX_SHAPE_PROXYTYPE) take(object, enterBox(object, ray));
        else if (&object == source.near.object && hasFaces(shape)) takeFaces(object);
        else return false;
        return true;
    }
    void takeFaces(const btCollisionObject& object) {
        know(source.near, object, ray, source.rounding.reach);
        take(object, meetFaces(source.near, ray));
    }
    void take(const btCollisionObject& object, const std::optional<Meets>& met) {
        if (!met || met->fraction >= static_cast<double>(m_closestHitFraction)) return;
        exact = met;
        m_collisionObject = &object;
        m_closestHitFraction = static_cast<btScalar>(met->fraction);
        m_hitPointWorld = toBullet(Vector3(ray.start_W + met->fraction * ray.way_W));
        m_hitNormalWorld = toBullet(met->normal_W);
        part = met->part;
        triangle = met->triangle;
    }
    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool normal_in_world) override {
        exact.reset();
        part = result.m_localShapeInfo ? result.m_localShapeInfo->m_shapePart : -1;
        triangle = result.m_localShapeInfo ? result.m_localShapeInfo->m_triangleIndex : -1;
        return ClosestRayResultCallback::addSingleResult(result, normal_in_world);
    }
    // Of a mesh or height field that Bullet met: from now on its faces are asked, and so they are now.
    void lookAround() {
        if (exact) return;
        const btCollisionObject& object = *m_collisionObject;
        know(source.near, object, ray, source.rounding.reach);
        if (!hasFaces(*object.getCollisionShape())) return;
        const std::optional<Meets> met = meetFaces(source.near, ray);
        if (met) m_closestHitFraction = 1;
        take(object, met);
    }
    const Way& ray;
    const RaySource& source;
    std::optional<Meets> exact;  // of what was met last
    int part = -1;
    int triangle = -1;
};

// Height of a rough surface: bumps about a metre long, the same whenever one comes there.
double bump(const Vector3& at, double amplitude) {
    if (amplitude == 0) return 0;
    return amplitude * (0.5 * std::sin(6.1 * at.x() + 2.3 * at.y() + 1.7 * at.z()) +
                        0.5 * std::sin(-2.9 * at.x() + 5.3 * at.y() + 3.1 * at.z() + 1));
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
    const Way way{ray.start_W(), ray.way_W()};
    FilteredGround hit(way, source);
    const Box box = Box::around(hit.m_rayFromWorld, hit.m_rayToWorld);
    if (!source.around.cover(box)) source.around.find(*source.world, box);
    for (btBroadphaseProxy* proxy : source.around.objects) {
        if (box.meets(*proxy) && hit.needsCollision(proxy))
            hit.askBullet(*static_cast<btCollisionObject*>(proxy->m_clientObject));
    }
    if (hit.triangle >= 0) hit.lookAround();
    const Vector3 normal = hit.exact ? hit.exact->normal_W : fromBullet(hit.m_hitNormalWorld);
    ground.plane.exists = hit.hasHit() && isUnit(normal);
    if (!ground.plane.exists) return ground;
    // Depth along the ray in double: the hit point itself is rounded to the world's precision.
    ground.handle = ground.object = const_cast<btCollisionObject*>(hit.m_collisionObject);
    const double fraction = hit.exact ? hit.exact->fraction : static_cast<double>(hit.m_closestHitFraction);
    ground.plane.point_W = way.start_W + fraction * way.way_W;
    ground.plane.normal_W = normal.normalized();
    if (ground.plane.normal_W.dot(ray.down_W) > 0) ground.plane.normal_W = -ground.plane.normal_W;
    if (hit.triangle >= 0 && source.rounding.angle > 0)
        ground.plane.normal_W = smoothNormal(source.near, ground.plane.point_W, ground.plane.normal_W, source.rounding);
    describe(ground, {ground.object, hit.part, hit.triangle, hit.m_hitPointWorld, ray.wheel}, source.surface);
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
