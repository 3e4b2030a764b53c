// Turns and angles, with the same bits on every machine (elementary.h says why).
#pragma once

#include <cmath>
#include <numbers>

#include "base/math/elementary.h"
#include "tread/vector.h"

namespace tread {

// By an angle in rad, to the left about an axis of length 1.
inline Quaternion turnAbout(const Vector3& axis, double angle) {
    const SineCosine<double> half = sineCosine(0.5 * angle);
    const Vector3 part = half.sine * axis;
    return {half.cosine, part.x(), part.y(), part.z()};
}

// The angle, plus whole turns, that is closest to the previous one; rad.
inline double unwrapped(double angle, double previous) {
    return angle - 2 * std::numbers::pi * std::round((angle - previous) / (2 * std::numbers::pi));
}

}  // namespace tread
