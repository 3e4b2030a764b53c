// A wheel on the plane of the road: where it touches, its axes there, how it moves over the road. The same for every
// car; what holds the wheel decides where its centre and its axis are. All in body axes.
#pragma once

#include "tread/vehicle.h"

namespace tread {

// The body's pose and velocities, as its wheels need them.
struct BodyMotion {
    Eigen::Matrix3d to_world;
    Vector3 position_W;
    Vector3 velocity_B;
    Vector3 angular_velocity_B;
};
BodyMotion bodyMotion(const ChassisMotion& motion);

inline Vector3 velocityAt(const BodyMotion& body, const Vector3& point_B) {
    return body.velocity_B + body.angular_velocity_B.cross(point_B);
}

struct WheelContact {
    Vector3 hub_B;      // m, wheel centre
    Vector3 point_B;    // m, contact centre
    Vector3 to_road_B;  // unit vector from the one to the other, in the wheel's plane
    Vector3 forward_B;  // unit vectors of the ISO 8855 wheel axes at the contact
    Vector3 left_B;
    Vector3 normal_B;
    Vector3 axis_B;  // of the spin
    double radius;   // m, wheel centre to road
    double camber;   // rad, against the road
    double cosine;   // of the camber
    double friction;
    bool exists;
    Vector3 ground_velocity_B;
};
WheelContact wheelContact(const Vector3& hub_B, const Vector3& axis_B, const BodyMotion& body,
                          const RoadContact& ground);

// Moves the wheel's centre against the body, its attitude kept.
inline void shift(WheelContact& contact, const Vector3& by_B) {
    contact.hub_B += by_B;
    contact.radius += by_B.dot(contact.normal_B) / contact.cosine;
    contact.point_B = contact.hub_B + contact.radius * contact.to_road_B;
}

// Rate at which the tyre is pressed in, m/s, when the wheel's centre moves with this velocity: the radius is measured
// in the wheel's plane, so that a leaning wheel is pressed in faster than it comes down.
inline double deflectionRate(const WheelContact& contact, const Vector3& hub_velocity_B) {
    return -(hub_velocity_B - contact.ground_velocity_B).dot(contact.normal_B) / contact.cosine;
}

// ---- Border with the paper's axes ----

// Motion of the tyre. `velocity_B` is that of the contact centre, taken as fixed to the wheel carrier, and `turning_B`,
// in rad/s, how the carrier turns; both in the world.
inline TyreMotion tyreMotion(const WheelContact& contact, const Vector3& velocity_B, const Vector3& turning_B,
                             double load) {
    const Vector3 over_road = velocity_B - contact.ground_velocity_B;
    TyreMotion motion;
    motion.Vx = over_road.dot(contact.forward_B);
    motion.Vsy = -over_road.dot(contact.left_B);
    motion.psidot = -turning_B.dot(contact.normal_B);
    motion.gamma = contact.camber;
    motion.Fz = load;
    return motion;
}

// Forces of the tyre, converted from the paper's axes to ISO 8855 wheel axes.
inline TyreForces toIso(const TyreForces& paper) {
    return {paper.Fx, -paper.Fy, paper.Mx, -paper.My, -paper.Mz};
}

}  // namespace tread
