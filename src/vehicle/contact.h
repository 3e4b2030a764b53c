// A wheel on the plane of the road: where it touches, its axes there, how it moves over the road. The same for every
// car; what holds the wheel decides where its centre and its axis are. All in body axes. T is double, or lanes of which
// each holds another car.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/vectors.h"

namespace tread {
inline namespace TREAD_ISA {

// Motion of a body, as ChassisMotion in vehicle.h.
template <class T>
struct LaneMotion {
    VectorOf<T> position_W;
    AttitudeOf<T> orientation;
    VectorOf<T> velocity_W;
    VectorOf<T> angular_velocity_W;
};
// The road under a wheel, as RoadContact in road.h.
template <class T>
struct LaneGround {
    VectorOf<T> point_W;
    VectorOf<T> normal_W;
    VectorOf<T> velocity_W;
    T friction;
    MaskOf<T> exists;
};

// The body's pose and velocities, as its wheels need them.
template <class T>
struct BasicBodyMotion {
    RotationOf<T> to_world;
    VectorOf<T> position_W;
    VectorOf<T> velocity_B;
    VectorOf<T> angular_velocity_B;
};
using BodyMotion = BasicBodyMotion<double>;

template <class T, class Motion>
BasicBodyMotion<T> bodyMotionOf(const Motion& motion) {
    const RotationOf<T> to_world = rotationOf<T>(motion.orientation);
    return {to_world, motion.position_W, transposedTimes<VectorOf<T>>(to_world, motion.velocity_W),
            transposedTimes<VectorOf<T>>(to_world, motion.angular_velocity_W)};
}
inline BodyMotion bodyMotion(const ChassisMotion& motion) {
    return bodyMotionOf<double>(motion);
}

template <class T>
VectorOf<T> velocityAt(const BasicBodyMotion<T>& body, const VectorOf<T>& point_B) {
    return body.velocity_B + body.angular_velocity_B.cross(point_B);
}

template <class T>
struct BasicWheelContact {
    VectorOf<T> hub_B;      // m, wheel centre
    VectorOf<T> point_B;    // m, contact centre
    VectorOf<T> to_road_B;  // unit vector from the one to the other, in the wheel's plane
    VectorOf<T> forward_B;  // unit vectors of the ISO 8855 wheel axes at the contact
    VectorOf<T> left_B;
    VectorOf<T> normal_B;
    VectorOf<T> axis_B;  // of the spin
    T radius;            // m, wheel centre to road
    T camber;            // rad, against the road
    T cosine;            // of the camber
    T friction;
    MaskOf<T> exists;
    VectorOf<T> ground_velocity_B;
};
using WheelContact = BasicWheelContact<double>;

template <class T, class Ground>
BasicWheelContact<T> wheelContact(const VectorOf<T>& hub_B, const VectorOf<T>& axis_B, const BasicBodyMotion<T>& body,
                                  const Ground& ground) {
    using Vector = VectorOf<T>;
    BasicWheelContact<T> contact;
    contact.hub_B = hub_B;
    contact.axis_B = axis_B;
    const Vector n = transposedTimes<Vector>(body.to_world, ground.normal_W);
    const Vector plane_B = transposedTimes<Vector>(body.to_world, ground.point_W - body.position_W);
    const T sine = dot(axis_B, n);
    constexpr double kFlat = 1e-12;  // of the cosine squared: a wheel that lies on its side has no forward direction
    contact.cosine = squareRoot(larger(T(1 - sine * sine), T(kFlat)));

    // Contact centre: down the wheel plane, onto the road.
    contact.to_road_B = (sine * axis_B - n) / contact.cosine;
    contact.radius = dot(hub_B - plane_B, n) / contact.cosine;
    contact.point_B = hub_B + contact.radius * contact.to_road_B;
    contact.forward_B = axis_B.cross(n) / contact.cosine;
    contact.left_B = n.cross(contact.forward_B);
    contact.normal_B = n;
    contact.camber = arctan(T(sine / contact.cosine));
    contact.friction = ground.friction;
    contact.exists = ground.exists;
    contact.ground_velocity_B = transposedTimes<Vector>(body.to_world, ground.velocity_W);
    return contact;
}

// Moves the wheel's centre against the body, its attitude kept.
template <class T>
void shift(BasicWheelContact<T>& contact, const VectorOf<T>& by_B) {
    contact.hub_B += by_B;
    contact.radius += dot(by_B, contact.normal_B) / contact.cosine;
    contact.point_B = contact.hub_B + contact.radius * contact.to_road_B;
}

// Rate at which the tyre is pressed in, m/s, when the wheel's centre moves with this velocity: the radius is measured
// in the wheel's plane, so that a leaning wheel is pressed in faster than it comes down.
template <class T>
T deflectionRate(const BasicWheelContact<T>& contact, const VectorOf<T>& hub_velocity_B) {
    return -dot(hub_velocity_B - contact.ground_velocity_B, contact.normal_B) / contact.cosine;
}

// ---- Border with the paper's axes ----

// Motion of the tyre. `velocity_B` is that of the contact centre, taken as fixed to the wheel carrier, and `turning_B`,
// in rad/s, how the carrier turns; both in the world.
template <class T>
BasicTyreMotion<T> tyreMotion(const BasicWheelContact<T>& contact, const VectorOf<T>& velocity_B,
                              const VectorOf<T>& turning_B, const T& load) {
    const VectorOf<T> over_road = velocity_B - contact.ground_velocity_B;
    BasicTyreMotion<T> motion;
    motion.Vx = dot(over_road, contact.forward_B);
    motion.Vsy = -dot(over_road, contact.left_B);
    motion.psidot = -dot(turning_B, contact.normal_B);
    motion.gamma = contact.camber;
    motion.Fz = load;
    return motion;
}

// Forces of the tyre, converted from the paper's axes to ISO 8855 wheel axes.
template <class T>
BasicTyreForces<T> toIso(const BasicTyreForces<T>& paper) {
    return {paper.Fx, -paper.Fy, paper.Mx, -paper.My, -paper.Mz};
}

}  // namespace TREAD_ISA
}  // namespace tread
