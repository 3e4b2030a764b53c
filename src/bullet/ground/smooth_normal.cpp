#include "bullet/ground/smooth_normal.h"

#include <algorithm>
#include <cmath>

#include "base/math/elementary.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// A face on which the ray's triangle lies is this near, and as parallel.
constexpr double kOnFace = 1e-3;  // m
constexpr double kSameNormal = 0.9999;

Vector3 upward(const NearFaces::Face& face, const Vector3& normal) {
    return face.normal_W.dot(normal) < 0 ? Vector3(-face.normal_W) : face.normal_W;
}

// What the faces make of a normal; zero when none of them is the one that the ray met.
Vector3 blend(const NearFaces& near, const Vector3& point, const Vector3& normal, const Rounding& rounding) {
    const double sharp = cosine(rounding.angle), reach = rounding.reach;
    Vector3 sum = Vector3::Zero();
    bool met = false;
    for (const NearFaces::Face& face : near.faces) {
        const double alike = std::abs(face.normal_W.dot(normal));
        if (alike < sharp) continue;
        const double beyond = outside(face, point);
        if (beyond > reach) continue;
        const double distance = distanceTo(face, point, beyond);
        const bool is_met = alike > kSameNormal && distance < kOnFace;
        if (is_met && beyond < -reach) return upward(face, normal);
        met |= is_met;
        const double share = std::max(1 - distance / reach, 0.0);
        sum += share * share * std::min(face.area, reach * reach) * upward(face, normal);
    }
    return met ? sum : Vector3(Vector3::Zero());
}

}  // namespace

Vector3 smoothNormal(const NearFaces& near, const Vector3& point_W, const Vector3& normal_W, const Rounding& rounding) {
    if (near.inside > rounding.reach) return upward(near.faces[near.met], normal_W);
    const Vector3 sum = blend(near, point_W, normal_W, rounding);
    const double length = sum.norm();
    return length > 0 ? Vector3(sum / length) : normal_W;
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
