#include "bullet/ground/near_faces.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btTriangleCallback.h>

#include <algorithm>
#include <cmath>

#include "bullet/convert.h"
#include "tread/describe.h"
#include "vehicle/vectors.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// Faces are looked up this many reaches around a way: fewer where that gives more of them than a ray should ask.
constexpr double kLookedUp = 4;
constexpr double kLookedUpAmongMany = 1.5;
constexpr std::size_t kMany = 60;
constexpr double kLongestKept = 0.034;  // s: two frames of a game
// Faces that are seldom exceeded: what a wheel keeps then takes memory once.
constexpr std::size_t kUsual = 48;
// Neighbours share their corners: a ray between two faces passes each by less than this.
constexpr double kBetweenFaces = 1e-9;  // m

bool overlap(const NearFaces::Face& face, const Vector3& low_W, const Vector3& high_W) {
    return (face.low_W.array() <= high_W.array()).all() && (face.high_W.array() >= low_W.array()).all();
}

// Collects the faces in the box. Most are there already when a box is looked up again, in the same order: those that
// did not change are kept as they are.
struct Gather : btTriangleCallback {
    Gather(NearFaces& n, std::size_t& c, const btTransform& pose, bool halves)
        : near(n), count(c), origin(fromBullet(pose.getOrigin())), axes(fromBullet(pose.getBasis())), halved(halves) {}
    void processTriangle(btVector3* corners, int part, int triangle) override {
        for (std::size_t k = 0; k < 3; ++k) face.corners_W[k] = origin + times(axes, fromBullet(corners[k]));
        const auto& [a, b, c] = face.corners_W;
        face.low_W = a.cwiseMin(b).cwiseMin(c);
        face.high_W = a.cwiseMax(b).cwiseMax(c);
        if (!overlap(face, near.low_W, near.high_W)) return;
        face.part = halved ? part / 2 : part;
        face.triangle = triangle;
        if (!isKept()) {
            const Vector3 across = (b - a).cross(c - a);
            const double twice = across.norm();
            if (!(twice > 0)) return;
            face.area = 0.5 * twice;
            face.normal_W = across / twice;
            for (std::size_t k = 0; k < 3; ++k)
                face.outward_W[k] = (face.corners_W[(k + 1) % 3] - face.corners_W[k]).cross(face.normal_W).normalized();
            if (count == near.faces.size()) near.faces.emplace_back();
            near.faces[count] = face;
        }
        ++count;
    }
    bool isKept() const {
        if (count == near.faces.size()) return false;
        const NearFaces::Face& known = near.faces[count];
        return known.triangle == face.triangle && known.part == face.part && known.corners_W == face.corners_W;
    }
    NearFaces& near;
    std::size_t& count;    // of the faces found so far
    NearFaces::Face face;  // the one at hand
    Vector3 origin;
    Eigen::Matrix3d axes;
    bool halved;  // the box query of a height field counts two faces a cell, its ray one
};

void gather(NearFaces& near, std::size_t& count, const btCollisionShape& shape, const btTransform& pose) {
    if (shape.isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(shape);
        for (int i = 0; i < compound.getNumChildShapes(); ++i)
            gather(near, count, *compound.getChildShape(i), pose * compound.getChildTransform(i));
        return;
    }
    if (!shape.isConcave() || shape.getShapeType() == STATIC_PLANE_PROXYTYPE) return;
    const btVector3 centre = pose.invXform(toBullet(Vector3(0.5 * (near.low_W + near.high_W))));
    const btVector3 half = pose.getBasis().transpose().absolute() * toBullet(Vector3(0.5 * (near.high_W - near.low_W)));
    Gather found(near, count, pose, shape.getShapeType() == TERRAIN_SHAPE_PROXYTYPE);
    static_cast<const btConcaveShape&>(shape).processAllTriangles(&found, centre - half, centre + half);
}

}  // namespace

bool hasFaces(const btCollisionShape& shape) {
    return shape.getShapeType() == TERRAIN_SHAPE_PROXYTYPE || shape.getShapeType() == TRIANGLE_MESH_SHAPE_PROXYTYPE;
}

void know(NearFaces& near, const btCollisionObject& object, const Way& way, double reach) {
    const Vector3 end = way.start_W + way.way_W;
    const Vector3 low = way.start_W.cwiseMin(end), high = way.start_W.cwiseMax(end);
    const bool same =
        near.object == &object && near.shape == object.getCollisionShape() && near.pose == object.getWorldTransform();
    const auto covers = [&] {
        return ((low - near.low_W).array() >= reach).all() && ((near.high_W - high).array() >= reach).all();
    };
    if (same && near.age < kLongestKept && covers()) return;
    const bool many = near.object == &object && near.faces.size() > kMany;
    const double around = (many ? kLookedUpAmongMany : kLookedUp) * reach;
    near.object = &object;
    near.shape = object.getCollisionShape();
    near.pose = object.getWorldTransform();
    near.low_W = low.array() - around;
    near.high_W = high.array() + around;
    near.age = 0;
    near.inside = 0;
    near.faces.reserve(kUsual);
    std::size_t count = 0;
    gather(near, count, *near.shape, near.pose);
    near.faces.resize(count);
}

std::optional<Meets> meetFaces(NearFaces& near, const Way& way) {
    std::optional<Meets> first;
    near.inside = 0;
    const Vector3 end = way.start_W + way.way_W;
    const Vector3 low = way.start_W.cwiseMin(end).array() - kBetweenFaces;
    const Vector3 high = way.start_W.cwiseMax(end).array() + kBetweenFaces;
    for (std::size_t i = 0; i < near.faces.size(); ++i) {
        const NearFaces::Face& face = near.faces[i];
        if (!overlap(face, low, high)) continue;
        const double fraction = face.normal_W.dot(face.corners_W[0] - way.start_W) / face.normal_W.dot(way.way_W);
        if (!(fraction >= 0 && fraction <= (first ? first->fraction : 1))) continue;
        const double beyond = outside(face, way.start_W + fraction * way.way_W);
        if (beyond > kBetweenFaces) continue;
        first = Meets{fraction, face.normal_W, face.part, face.triangle};
        near.met = i;
        near.inside = std::max(-beyond, 0.0);
    }
    return first;
}

double outside(const NearFaces::Face& face, const Vector3& point) {
    return std::max({face.outward_W[0].dot(point - face.corners_W[0]), face.outward_W[1].dot(point - face.corners_W[1]),
                     face.outward_W[2].dot(point - face.corners_W[2])});
}

// The nearest point of a triangle lies inside it or on an edge.
double distanceTo(const NearFaces::Face& face, const Vector3& point, double beyond) {
    if (beyond <= 0) return std::abs(face.normal_W.dot(point - face.corners_W[0]));
    double nearest = kInfinity;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 &a = face.corners_W[k], &b = face.corners_W[(k + 1) % 3];
        const Vector3 edge = b - a, to_point = point - a;
        const double along = std::clamp(to_point.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (to_point - along * edge).squaredNorm());
    }
    return std::sqrt(nearest);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
