// Which body of the world is the ground under a wheel, and where its ray meets it.
//
// What a ray meets below the hard point, the connection point of the strut, is ground as in the stock vehicle. Above
// it, as far as the ray is raised, only what never moves and holds the hard point is: a wheel gets out of a hill, but
// what a car carries, or drives under, does not lift it.
#pragma once

#include <optional>

#include "bullet/ground/wheel_ray.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

struct GroundHit {
    btCollisionObject* object;
    Vector3 point_W;
    Vector3 normal_W;  // as the body has it: to either side, perhaps no unit vector
    int part, triangle;
};

// `source.world` must not be null.
std::optional<GroundHit> findGround(const WheelRay& ray, const RaySource& source);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
