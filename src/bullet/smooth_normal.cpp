#include "bullet/smooth_normal.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btTriangleCallback.h>

#include <algorithm>
#include <cmath>

#include "bullet/convert.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// Faces are looked up this many reaches around a point, and anew when a point has come closer than one to that border.
constexpr double kLookedUp = 3;
// A face on which the ray's triangle lies is this near, and as parallel.
constexpr double kOnFace = 1e-3;  // m
constexpr double kSameNormal = 0.9999;

struct Gather : btTriangleCallback {
    Gather(NearFaces& n, const btTransform& p) : near(n), pose(p) {}
    void processTriangle(btVector3* corners, int, int) override {
        NearFaces::Face face;
        for (std::size_t k = 0; k < 3; ++k) face.corners_W[k] = fromBullet(pose * corners[k]);
        const Vector3 across = (face.corners_W[1] - face.corners_W[0]).cross(face.corners_W[2] - face.corners_W[0]);
        face.area = 0.5 * across.norm();
        if (!(face.area > 0)) return;
        face.normal_W = across / (2 * face.area);
        for (std::size_t k = 0; k < 3; ++k)
            face.outward_W[k] = (face.corners_W[(k + 1) % 3] - face.corners_W[k]).cross(face.normal_W).normalized();
        if (distanceTo(face, near.centre_W) < near.radius) near.faces.push_back(face);
    }
    NearFaces& near;
    const btTransform& pose;
};

void gather(NearFaces& near, const btCollisionShape& shape, const btTransform& pose) {
    if (shape.isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(shape);
        for (int i = 0; i < compound.getNumChildShapes(); ++i)
            gather(near, *compound.getChildShape(i), pose * compound.getChildTransform(i));
        return;
    }
    if (!shape.isConcave() || shape.getShapeType() == STATIC_PLANE_PROXYTYPE) return;
    const btVector3 centre = pose.invXform(toBullet(near.centre_W));
    const auto r = static_cast<btScalar>(near.radius);
    const btVector3 half(r, r, r);
    Gather found(near, pose);
    static_cast<const btConcaveShape&>(shape).processAllTriangles(&found, centre - half, centre + half);
}

// How far a point lies outside the edges of a face, seen along its normal; negative inside.
double outside(const NearFaces::Face& face, const Vector3& point) {
    return std::max({face.outward_W[0].dot(point - face.corners_W[0]), face.outward_W[1].dot(point - face.corners_W[1]),
                     face.outward_W[2].dot(point - face.corners_W[2])});
}

Vector3 upward(const NearFaces::Face& face, const Vector3& normal) {
    return face.normal_W.dot(normal) < 0 ? Vector3(-face.normal_W) : face.normal_W;
}

// Whether the ray met this face, and farther from its edges than anything is rounded.
bool isWithin(const NearFaces::Face& face, const Vector3& point, const Vector3& normal, double reach) {
    return std::abs(face.normal_W.dot(normal)) > kSameNormal && outside(face, point) < -reach &&
           std::abs(face.normal_W.dot(point - face.corners_W[0])) < kOnFace;
}

// What the faces make of a normal; zero when none of them is the one that the ray met.
Vector3 blend(NearFaces& near, const Vector3& point, const Vector3& normal, const Rounding& rounding) {
    const double sharp = std::cos(rounding.angle), reach = rounding.reach;
    Vector3 sum = Vector3::Zero();
    bool met = false;
    for (std::size_t i = 0; i < near.faces.size(); ++i) {
        const NearFaces::Face& face = near.faces[i];
        if (std::abs(face.normal_W.dot(normal)) < sharp || outside(face, point) > reach) continue;
        if (isWithin(face, point, normal, reach)) {
            near.met = i;
            return upward(face, normal);
        }
        const double distance = distanceTo(face, point);
        met |= std::abs(face.normal_W.dot(normal)) > kSameNormal && distance < kOnFace;
        const double share = std::max(1 - distance / reach, 0.0);
        sum += share * share * std::min(face.area, reach * reach) * upward(face, normal);
    }
    return met ? sum : Vector3(Vector3::Zero());
}

}  // namespace

// The nearest point of a triangle lies inside it or on an edge.
double distanceTo(const NearFaces::Face& face, const Vector3& point) {
    if (outside(face, point) <= 0) return std::abs(face.normal_W.dot(point - face.corners_W[0]));
    double nearest = kInfinity;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 &a = face.corners_W[k], &b = face.corners_W[(k + 1) % 3];
        const Vector3 edge = b - a, to_point = point - a;
        const double along = std::clamp(to_point.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (to_point - along * edge).squaredNorm());
    }
    return std::sqrt(nearest);
}

Vector3 smoothNormal(NearFaces& near, const btCollisionObject& object, const Vector3& point_W, const Vector3& normal_W,
                     const Rounding& rounding) {
    const double reach = rounding.reach;
    const bool same =
        near.object == &object && near.shape == object.getCollisionShape() && near.pose == object.getWorldTransform();
    if (same && near.met < near.faces.size() && isWithin(near.faces[near.met], point_W, normal_W, reach))
        return upward(near.faces[near.met], normal_W);
    const bool known =
        same && near.radius >= kLookedUp * reach && (point_W - near.centre_W).norm() + reach < near.radius;
    Vector3 sum = known ? blend(near, point_W, normal_W, rounding) : Vector3(Vector3::Zero());
    if (sum.isZero(0)) {
        near.object = &object;
        near.shape = object.getCollisionShape();
        near.pose = object.getWorldTransform();
        near.centre_W = point_W;
        near.radius = kLookedUp * reach;
        near.faces.clear();
        gather(near, *near.shape, near.pose);
        sum = blend(near, point_W, normal_W, rounding);
    }
    const double length = sum.norm();
    return length > 0 ? Vector3(sum / length) : normal_W;
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
