#include "bullet/ground/ground_search.h"

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "bullet/convert.h"
#include "bullet/ground/ground_below.h"
#include "tread/describe.h"

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

// m: a gap that a ray of Bullet's can tell from none, 10 km from the origin in single precision. What is thinner has no
// inside.
constexpr double kThinnest = 1e-3;

// Bullet's answer for one object.
struct Asked : GroundBelow {
    Asked(const Way& way, const btCollisionObject& own)
        : GroundBelow(toBullet(way.start_W), toBullet(Vector3(way.start_W + way.way_W)), own) {
        m_flags |= btTriangleRaycastCallback::kF_KeepUnflippedNormal;
    }
    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool normal_in_world) override {
        // A body that holds the start is not met, but may be said to be met there.
        if (!(result.m_hitFraction > 0)) return m_closestHitFraction;
        part = result.m_localShapeInfo ? result.m_localShapeInfo->m_shapePart : -1;
        triangle = result.m_localShapeInfo ? result.m_localShapeInfo->m_triangleIndex : -1;
        return ClosestRayResultCallback::addSingleResult(result, normal_in_world);
    }
    int part = -1;
    int triangle = -1;
};

// Whether the object stays where it is: what a car carries does not.
bool neverMoves(const btCollisionObject& object) {
    const int kind = object.getInternalType(), flags = object.getCollisionFlags();
    constexpr int kMoves = btCollisionObject::CF_KINEMATIC_OBJECT | btCollisionObject::CF_CHARACTER_OBJECT;
    return (kind == btCollisionObject::CO_RIGID_BODY || kind == btCollisionObject::CO_COLLISION_OBJECT) &&
           object.isStaticObject() && (flags & kMoves) == 0;
}

// A body that was met, and where.
struct Hit {
    Meets met{.fraction = 0, .normal_W = Vector3::Zero()};
    const Way* way = nullptr;
    btCollisionObject* object = nullptr;  // null: nothing was met
    double depth = kInfinity;             // m, below the hard point
    bool by_bullet = false;

    Vector3 point_W() const { return way->start_W + met.fraction * way->way_W; }
};

// Looks from body to body for the ground. Planes, boxes and the faces of the mesh or height field on which the wheel
// stood last are met exactly, and without Bullet.
class Search {
public:
    Search(const WheelRay& r, const RaySource& s)
        : ray_(r),
          source_(s),
          whole_{r.start_W(), r.way_W()},
          below_{r.top_W, r.below() * r.down_W},
          filter_(toBullet(whole_.start_W), toBullet(Vector3(whole_.start_W + whole_.way_W)), s.chassis) {
        filter_.m_collisionFilterGroup = source_.filter.group;
        filter_.m_collisionFilterMask = source_.filter.mask;
    }
    Box box() const { return Box::around(filter_.m_rayFromWorld, filter_.m_rayToWorld); }

    void lookAt(btBroadphaseProxy& proxy) {
        auto& object = *static_cast<btCollisionObject*>(proxy.m_clientObject);
        if (!filter_.needsCollision(&proxy) || !source_.chassis.checkCollideWith(&object)) return;
        if (!neverMoves(object)) {
            take(meet(object, below_, ground_.depth));
            return;
        }
        const Hit hit = meet(object, whole_, ground_.depth);
        if (!isAbove(hit)) {
            take(hit);
            return;
        }
        above_.push_back({hit, meet(object, below_, kInfinity)});
        take(above_.back().below);
    }

    // When all bodies were looked at.
    Hit ground() {
        const bool carried = ground_.object;
        for (const Above& above : above_) {
            if (above.hit.depth < ground_.depth && holdsHardPoint(above, carried)) ground_ = above.hit;
        }
        if (ground_.object && ground_.met.triangle >= 0) knowFaces();
        return ground_;
    }

private:
    // A body met above the hard point, and what the ray meets of it below.
    struct Above {
        Hit hit, below;
    };

    static bool isAbove(const Hit& hit) { return hit.object && hit.depth < 0; }
    static bool facesUp(const Hit& hit) { return hit.met.normal_W.dot(hit.way->way_W) < 0; }
    static bool isConcave(const btCollisionObject& object) {
        const btCollisionShape& shape = *object.getCollisionShape();
        return shape.isConcave() && shape.getShapeType() != STATIC_PLANE_PROXYTYPE;
    }
    static bool isField(const btCollisionObject& object) {
        return object.getCollisionShape()->getShapeType() == TERRAIN_SHAPE_PROXYTYPE;
    }
    bool isUpright() const { return ray_.down_W.dot(fromBullet(source_.chassis.getGravity())) >= 0; }

    // Whether the ray comes into the body where it meets it. A mesh may be open, with an inside on neither side, and
    // its faces may look to either; those of a height field look to where its options turn them. So a rolled car,
    // whose roof lies on them, has none of them above its hard points. Where something carries the wheel below, what is
    // above must be the upper side of its faces, and not stand over an upper side of the same mesh, as a bridge over
    // its road.
    bool comesIn(const Above& above, bool carried) const {
        if (!isConcave(*above.hit.object)) return facesUp(above.hit);
        if (!isUpright()) return false;
        if (isField(*above.hit.object) || !carried) return true;
        return facesUp(above.hit) && !(above.below.object && facesUp(above.below));
    }

    // Whether it also does not leave it before the hard point.
    bool holdsHardPoint(const Above& above, bool carried) {
        if (!comesIn(above, carried)) return false;
        const Way up{ray_.top_W, (above.hit.depth + kThinnest) * ray_.down_W};
        return above.hit.depth > -kThinnest || !meet(*above.hit.object, up, kInfinity).object;
    }

    // What a way along the strut meets of the object, if less deep than `depth`.
    Hit meet(btCollisionObject& object, const Way& way, double depth) {
        const btCollisionShape& shape = *object.getCollisionShape();
        std::optional<Meets> met;
        bool by_bullet = false;
        if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) met = meetPlane(object, way);
        else if (shape.getShapeType() == BOX_SHAPE_PROXYTYPE) met = enterBox(object, way);
        else if (&object == source_.near.object && hasFaces(shape)) met = meetKnownFaces(object, way);
        else {
            met = askBullet(object, way, depth);
            by_bullet = true;
        }
        if (!met) return {};
        const double at = depthOf(way, met->fraction);
        return at < depth ? Hit{*met, &way, &object, at, by_bullet} : Hit{};
    }
    double depthOf(const Way& way, double fraction) const {
        if (&way == &whole_) return fraction * (ray_.raised + ray_.below()) - ray_.raised;
        return fraction * way.way_W.dot(ray_.down_W);
    }
    std::optional<Meets> meetKnownFaces(const btCollisionObject& object, const Way& way) {
        know(source_.near, object, whole_, source_.rounding.reach);
        return meetFaces(source_.near, way);
    }
    std::optional<Meets> askBullet(btCollisionObject& object, const Way& way, double depth) const {
        Asked asked(way, source_.chassis);
        if (depth < kInfinity) asked.m_closestHitFraction = std::min(btScalar(1), fractionOf(way, depth));
        const btTransform from(btQuaternion::getIdentity(), asked.m_rayFromWorld),
            to(btQuaternion::getIdentity(), asked.m_rayToWorld);
        btCollisionWorld::rayTestSingle(from, to, &object, object.getCollisionShape(), object.getWorldTransform(),
                                        asked);
        if (!asked.hasHit()) return {};
        return Meets{static_cast<double>(asked.m_closestHitFraction), fromBullet(asked.m_hitNormalWorld), asked.part,
                     asked.triangle};
    }
    btScalar fractionOf(const Way& way, double depth) const {
        const double raised = &way == &whole_ ? ray_.raised : 0;
        return static_cast<btScalar>((raised + depth) / (raised + ray_.below()));
    }

    void take(const Hit& hit) {
        if (hit.depth < ground_.depth) ground_ = hit;
    }
    // Of a mesh or height field that Bullet met: from now on its faces are asked, and so they are now. They remember
    // which face was met last.
    void knowFaces() {
        if (!ground_.by_bullet && above_.empty()) return;
        const btCollisionObject& object = *ground_.object;
        know(source_.near, object, whole_, source_.rounding.reach);
        if (!hasFaces(*object.getCollisionShape())) return;
        const std::optional<Meets> met = meetFaces(source_.near, *ground_.way);
        if (met) ground_.met = *met;
    }

    const WheelRay& ray_;
    const RaySource& source_;
    const Way whole_, below_;  // from the raised start, and from the hard point
    GroundBelow filter_;
    Hit ground_;                // the least deep so far
    std::vector<Above> above_;  // seldom anything
};

}  // namespace

std::optional<GroundHit> findGround(const WheelRay& ray, const RaySource& source) {
    Search search(ray, source);
    const Box box = search.box();
    if (!source.around.cover(box)) source.around.find(*source.world, box);
    for (btBroadphaseProxy* proxy : source.around.objects) {
        if (box.meets(*proxy)) search.lookAt(*proxy);
    }
    const Hit hit = search.ground();
    if (!hit.object) return {};
    // In double: Bullet's hit point is rounded to the world's precision.
    return GroundHit{hit.object, hit.point_W(), hit.met.normal_W, hit.met.part, hit.met.triangle};
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
