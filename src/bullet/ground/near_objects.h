// What the rays of a car can meet within a step: asked of the world once for all its wheels.
#pragma once

#include <LinearMath/btVector3.h>

#include <vector>

#include "tread/bullet_precision.h"

struct btBroadphaseProxy;
class btCollisionWorld;

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// Parallel to the axes of the world, m.
struct Box {
    btVector3 low, high;

    static Box around(btVector3 from, const btVector3& to) {
        Box box{from, from};
        box.include(to);
        return box;
    }
    void include(const btVector3& point) {
        low.setMin(point);
        high.setMax(point);
    }
    bool contains(const btVector3& point) const;
    bool meets(const btBroadphaseProxy& object) const;
};

struct NearObjects {
    Box box;  // all that touch it are there
    std::vector<btBroadphaseProxy*> objects;
    bool known = false;  // in this step

    bool cover(const Box& other) const { return known && box.contains(other.low) && box.contains(other.high); }
    void find(const btCollisionWorld& world, const Box& within);
};
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
