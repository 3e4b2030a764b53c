// What lies under a wheel, found by a ray along its strut.
//
// What the ray meets below the hard point (the top of the strut) is ground, as for the stock vehicle. A wheel may also
// have come so far into a steep obstacle, or in a hard landing into the ground, that the hard point itself lies inside:
// then the surface up to one radius above it is ground. Only of what never moves and holds the hard point: what lies on
// the car, hangs on it or reaches over its wheels carries none of them.
#pragma once

#include <span>

#include "bullet/ground/near_objects.h"
#include "bullet/ground/smooth_normal.h"
#include "tread/bullet_precision.h"
#include "tread/raycast_vehicle.h"
#include "tread/road.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

struct WheelGround {
    RoadContact plane;
    void* handle = nullptr;               // what the ray gave: a user's may be anything
    btCollisionObject* object = nullptr;  // for use within the step that found it, or while isThere() says so
    int place = -1;                       // in the world's list of objects
    btTransform pose;                     // of the object then
    Surface surface;
    Vector3 cast_at = Vector3::Zero();  // m, top of the strut then
    bool known = false;
};

// Whether the object is still in the world and where it was: asked without touching one that may be gone.
bool isThere(const WheelGround& ground, const btCollisionWorld& world);

// The rigid body that a wheel stands on, or null; within the step that found it.
btRigidBody* bodyUnder(const WheelGround& ground);

struct WheelRay {
    Vector3 top_W;   // m, top of the strut
    Vector3 down_W;  // unit vector
    double raised;   // m, how far above the top the ray starts
    double length;   // m, from the top to where the unloaded tyre ends
    double ahead;    // m, how much farther the wheel may come within the step
    int wheel;

    double below() const { return length + ahead; }
    Vector3 start_W() const { return top_W - raised * down_W; }
    Vector3 way_W() const { return (raised + below()) * down_W; }
    bool isFinite() const { return top_W.allFinite() && down_W.allFinite(); }
};

// As those of btDefaultVehicleRaycaster.
struct RayFilter {
    int group = btBroadphaseProxy::DefaultFilter;
    int mask = btBroadphaseProxy::AllFilter;
};

// Where rays go: into the world, past the chassis, what it does not collide with and what has no contact response; or,
// with a user's raycaster, from the top of the strut and as far as in the stock vehicle.
struct RaySource {
    const btRigidBody& chassis;
    const btCollisionWorld* world;  // may be null
    btVehicleRaycaster* user;       // may be null
    RayFilter filter;
    SurfaceSource* surface;  // may be null
    const Rounding& rounding;
    NearObjects& around;
    NearFaces& near;  // of this wheel
};
// Looks up what the rays of all wheels can meet.
void lookAround(NearObjects& around, const btCollisionWorld& world, std::span<const WheelRay> rays);

WheelGround castRay(const WheelRay& ray, const RaySource& source);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
