// What a wheel needs to know of the road.
#pragma once

#include <cstddef>

#include "tread/api.h"
#include "tread/vector.h"

namespace tread {

// The road under one wheel, as its tangent plane.
struct RoadContact {
    Vector3 point_W = Vector3::Zero();     // m, any point of the plane
    Vector3 normal_W = Vector3::UnitZ();   // unit vector, out of the road
    Vector3 velocity_W = Vector3::Zero();  // m/s, of the ground itself
    double friction = 1;                   // scales the friction of the tyre file (lambda_mux, lambda_muy)
    bool exists = true;                    // false: nothing under the wheel
};

class TREAD_API Road {
public:
    virtual ~Road();

    // Called before each step of the world, of which the car may make several of its own: a road whose queries are dear
    // may ask once per wheel and answer with that plane until the next call.
    virtual void beginStep() {}

    // The road below a wheel centre. `wheel` lets a road keep what it found for that wheel.
    virtual RoadContact contact(const Vector3& centre_W, std::size_t wheel) const = 0;
};

}  // namespace tread
