// A turn about an axis, with the same bits on every machine (elementary.h says why).
#pragma once

#include "base/elementary.h"
#include "tread/vector.h"

namespace tread {

// By an angle in rad, to the left about an axis of length 1.
inline Quaternion turnAbout(const Vector3& axis, double angle) {
    const SineCosine<double> half = sineCosine(0.5 * angle);
    const Vector3 part = half.sine * axis;
    return {half.cosine, part.x(), part.y(), part.z()};
}

}  // namespace tread
