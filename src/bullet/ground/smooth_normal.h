// The normal of a triangle mesh or height field, rounded over its flat edges, so that a wheel that rolls from triangle
// to triangle of one surface is not kicked.
//
// The faces near a point share its normal: each by how near it is, up to the reach, so that the normal changes as
// gradually as the point moves. On edges as sharp as the given angle each face keeps its own.
#pragma once

#include "bullet/ground/near_faces.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

struct Rounding {
    double angle = 0.45;  // rad, between faces: from here on an edge is one
    double reach = 0.1;   // m
};

// The rounded normal at a point where a ray met a face of this normal; all faces within reach are near.
Vector3 smoothNormal(const NearFaces& near, const Vector3& point_W, const Vector3& normal_W, const Rounding& rounding);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
