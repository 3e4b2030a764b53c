// The faces of a mesh or height field around a wheel, kept while the wheel stays among them: its ray and the rounding
// of its normal ask these few in place of the shape.
#pragma once

#include <LinearMath/btTransform.h>

#include <array>
#include <optional>
#include <vector>

#include "tread/bullet_precision.h"
#include "tread/vector.h"

class btCollisionObject;
class btCollisionShape;

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

struct NearFaces {
    struct Face {
        std::array<Vector3, 3> corners_W;
        std::array<Vector3, 3> outward_W;  // unit vectors along the face, across each corner's edge to the next
        Vector3 normal_W;                  // unit vector, to either side
        double area;                       // m2
        Vector3 low_W, high_W;             // m, corners of its box
        int part, triangle;                // as Bullet's ray names it
    };
    std::vector<Face> faces;  // all that touch the box
    std::size_t met = 0;      // the face that the ray met last
    double inside = 0;        // m, how far from its edges; 0: the ray met none
    const btCollisionObject* object = nullptr;
    const btCollisionShape* shape = nullptr;
    btTransform pose;
    Vector3 low_W = Vector3::Zero(), high_W = Vector3::Zero();  // m, corners of the box
    double age = 0;                                             // s, since they were looked up
};

// A ray from `start` to `start + way`, m.
struct Way {
    Vector3 start_W, way_W;
};

// Where a ray meets a body, as a fraction of its way, and the normal there.
struct Meets {
    double fraction;
    Vector3 normal_W;
    int part = -1, triangle = -1;
};

// Whether Bullet's own rays meet such a shape face by face, so that its faces can stand for it.
bool hasFaces(const btCollisionShape& shape);

// Looks up the faces that lie within `reach` of the way, unless they are known. What a game changes in place, in the
// heights of a field or the corners of a mesh, is seen within 35 ms.
void know(NearFaces& near, const btCollisionObject& object, const Way& way, double reach);

// The first of the known faces that the ray meets.
std::optional<Meets> meetFaces(NearFaces& near, const Way& way);

// How far a point lies outside the edges of a face, seen along its normal; negative inside.
double outside(const NearFaces::Face& face, const Vector3& point);

// Of a face to a point that lies so far `beyond` its edges.
double distanceTo(const NearFaces::Face& face, const Vector3& point, double beyond);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
