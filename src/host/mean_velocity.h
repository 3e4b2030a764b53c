// The velocity that takes a body from one attitude to another in a given time.
#pragma once

#include "base/math/elementary.h"
#include "tread/vector.h"

namespace tread {

// Rotation vector of the turn from a to b, divided by dt.
inline Vector3 meanAngularVelocity(const Quaternion& a, const Quaternion& b, double dt) {
    Quaternion turn = b * a.conjugate();
    if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
    const double half_sine = turn.vec().norm();
    if (half_sine == 0) return Vector3::Zero();
    const double angle = 2 * arctan2(half_sine, turn.w());
    return turn.vec() * (angle / half_sine / dt);
}

}  // namespace tread
