// The normal of a triangle mesh or height field, rounded over its flat edges, so that a wheel that rolls from triangle
// to triangle of one surface is not kicked.
//
// The faces near a point share its normal: each by how near it is, up to the reach, so that the normal changes as
// gradually as the point moves. On edges as sharp as the given angle each face keeps its own.
#pragma once

#include <vector>

#include "tread/bullet_precision.h"
#include "tread/raycast_vehicle.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

struct Rounding {
    double angle = 0.45;  // rad, between faces: from here on an edge is one
    double reach = 0.1;   // m
};

// The faces around the last point, for the points that follow.
struct NearFaces {
    struct Face {
        std::array<Vector3, 3> corners_W;
        std::array<Vector3, 3> outward_W;  // unit vectors along the face, across each corner's edge to the next
        Vector3 normal_W;                  // unit vector, to either side
        double area;                       // m2
    };
    std::vector<Face> faces;
    std::size_t met = 0;  // the face that the ray met last
    const btCollisionObject* object = nullptr;
    const btCollisionShape* shape = nullptr;
    btTransform pose;
    Vector3 centre_W = Vector3::Zero();
    double radius = 0;  // m, around the centre: all faces that come so near are there
};

// The rounded normal at a point where a ray met the object's triangle of this normal.
Vector3 smoothNormal(NearFaces& near, const btCollisionObject& object, const Vector3& point_W, const Vector3& normal_W,
                     const Rounding& rounding);

// Of a face, to the point.
double distanceTo(const NearFaces::Face& face, const Vector3& point);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
