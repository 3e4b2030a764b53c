// One wheel of the car: its frame of reference, its contact with the road, its load. T is double, or lanes of which
// each holds another car.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/contact.h"
#include "vehicle/tyre_load.h"

namespace tread {
inline namespace TREAD_ISA {

// The body's motion and the surroundings as one wheel sees them, all in body axes.
template <class T>
struct BasicBodyFrame {
    BasicBodyMotion<T> motion;
    VectorOf<T> acceleration_B;  // as it was at the end of the last step
    VectorOf<T> angular_acceleration_B;
    VectorOf<T> gravity_B;
};
using BodyFrame = BasicBodyFrame<double>;

// How states keep a vector: trivially copyable.
template <class T>
VectorOf<T> toVector(const std::array<T, 3>& a) {
    return {a[0], a[1], a[2]};
}

template <class T, class Motion, class State>
BasicBodyFrame<T> bodyFrameOf(const Motion& motion, const State& state, const VectorOf<T>& gravity_W) {
    using Vector = VectorOf<T>;
    BasicBodyFrame<T> body;
    body.motion = bodyMotionOf<T>(motion);
    const RotationOf<T>& to_world = body.motion.to_world;
    body.acceleration_B = transposedTimes<Vector>(to_world, toVector(state.acceleration_W));
    body.angular_acceleration_B = transposedTimes<Vector>(to_world, toVector(state.angular_acceleration_W));
    body.gravity_B = transposedTimes<Vector>(to_world, gravity_W);
    return body;
}
inline BodyFrame bodyFrame(const ChassisMotion& motion, const VehicleState& state, const Vector3& gravity_W) {
    return bodyFrameOf<double>(motion, state, gravity_W);
}

// How the suspension holds a wheel against the body.
template <class T>
struct BasicWheelPose {
    VectorOf<T> displacement_B;  // m, of the wheel centre, from where it is at static load
    T camber;                    // rad, rotation about x
    T steer;                     // rad, then about z
};
using WheelPose = BasicWheelPose<double>;

template <class T, class Corner, class Ground>
BasicWheelContact<T> wheelContactOf(const BasicBodyFrame<T>& body, const Corner& corner, const BasicWheelPose<T>& pose,
                                    const Ground& road, std::size_t wheel) {
    using Vector = VectorOf<T>;
    const BasicBodyMotion<T>& motion = body.motion;
    const Vector hub_B = corner.hub_B + pose.displacement_B;
    const Vector hub_W = motion.position_W + times<Vector>(motion.to_world, hub_B);

    // Spin axis: the lateral axis, leant by camber about x, then steered about z.
    const SineCosine<T> lean = sineCosine(pose.camber), steer = sineCosine(pose.steer);
    const Vector axis_B(-steer.sine * lean.cosine, steer.cosine * lean.cosine, lean.sine);
    return wheelContact<T>(hub_B, axis_B, motion, road.contact(hub_W, wheel));
}
inline WheelContact wheelContact(const BodyFrame& body, const Vehicle::Corner& corner, const WheelPose& pose,
                                 const Road& road, std::size_t wheel) {
    return wheelContactOf<double>(body, corner, pose, road, wheel);
}

// Load of a wheel whose travel grows at `rate`.
template <class T, class Corner>
BasicTyreLoad<T> tyreLoad(const Corner& corner, const BasicWheelContact<T>& contact, const BasicBodyFrame<T>& body,
                          const T& rate) {
    using Vector = VectorOf<T>;
    const Vector hub_velocity = velocityAt(body.motion, contact.hub_B) + Vector(0, 0, rate);
    const T closing = deflectionRate<T>(contact, hub_velocity);
    // Where there is no road, nothing is pressed in.
    const T deflection = select(contact.exists, T(corner.tyre.parameters.Ro - contact.radius), T(0));
    return tyreLoad<T>(corner.tyre, {deflection, closing, closing});
}

// `slopes` is how the contact moves in the body over the suspension travel, `yaw_rate` the steering rate of the wheel.
template <class T>
BasicTyreMotion<T> tyreMotion(const BasicWheelContact<T>& contact, const BasicBodyFrame<T>& body,
                              const VectorOf<T>& slopes, const T& rate, const T& yaw_rate, const T& load) {
    using Vector = VectorOf<T>;
    const Vector velocity = velocityAt(body.motion, contact.point_B) + rate * slopes;
    const Vector turning = body.motion.angular_velocity_B + Vector(0, 0, yaw_rate);
    return tyreMotion<T>(contact, velocity, turning, load);
}

// By how much about, and rather too much, the aligning moment falls within a step with the rate at which the wheel is
// turned, N m s/rad: the force (26) accelerates the contact patch, and its motion makes the couple (25).
template <class T, class Corner>
T turningResistance(const Corner& corner, const T& spin, double dt) {
    constexpr double kSteps = 3;  // an answer as late as that would still swing
    const auto& p = corner.tyre.parameters;
    const T force = p.cygyr * p.Ro * p.mt * spin;   // over the rate of turning (26)
    const T couple = p.czgyr * p.Ro * p.mt * spin;  // over the speed of the patch (25)
    // What slides in the patch damps it besides; at the limit of grip little does.
    return larger(T(couple * force), T(0)) / (p.mc / (kSteps * dt) + p.kFy);
}

}  // namespace TREAD_ISA
}  // namespace tread
