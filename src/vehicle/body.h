// The body of the car as one rigid mass on which the wheels push: prediction and correction of its motion. T is double,
// or lanes of which each holds another car.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/wheel.h"

namespace tread {

// What the air does to the body.
struct AirPush {
    std::array<double, 3> force_B;   // N, at the centre of gravity
    std::array<double, 3> moment_B;  // N m, about it
};
AirPush airPush(const VehicleParams& params, const std::array<double, 3>& air_velocity_B);

// How states keep a vector: trivially copyable.
inline std::array<double, 3> toArray(const Vector3& v) {
    return {v.x(), v.y(), v.z()};
}

inline namespace TREAD_ISA {

// Force at the centre of gravity and moment about it, body axes.
template <class T>
struct BasicWrench {
    VectorOf<T> force_B = VectorOf<T>::Zero();
    VectorOf<T> moment_B = VectorOf<T>::Zero();

    void add(const VectorOf<T>& force, const VectorOf<T>& at) {
        force_B += force;
        moment_B += at.cross(force);
    }
    void add(const BasicWrench& other) {
        force_B += other.force_B;
        moment_B += other.moment_B;
    }
};
using Wrench = BasicWrench<double>;

// Position and attitude after dt, velocities predicted with the accelerations of the last step.
template <class T, class Motion>
Motion predictedMotion(const Motion& from, const std::array<T, 3>& acceleration_W,
                       const std::array<T, 3>& angular_acceleration_W, double dt) {
    const VectorOf<T> a = toVector(acceleration_W);
    const VectorOf<T> alpha = toVector(angular_acceleration_W);
    Motion to;
    to.position_W = from.position_W + dt * (from.velocity_W + 0.5 * dt * a);
    const VectorOf<T> turn = dt * (from.angular_velocity_W + 0.5 * dt * alpha);
    to.orientation = turned<T>(from.orientation, turn);
    to.velocity_W = from.velocity_W + dt * a;
    to.angular_velocity_W = from.angular_velocity_W + dt * alpha;
    return to;
}
inline ChassisMotion predicted(const ChassisMotion& from, const std::array<double, 3>& acceleration_W,
                               const std::array<double, 3>& angular_acceleration_W, double dt) {
    return predictedMotion<double>(from, acceleration_W, angular_acceleration_W, dt);
}

// Replaces the predicted velocities by those that the accelerations at the end of the step give, and keeps these in
// place of the last ones.
template <class T>
struct BasicAccelerations {
    VectorOf<T> linear_W;   // m/s2, of the centre of gravity
    VectorOf<T> angular_W;  // rad/s2
};
using Accelerations = BasicAccelerations<double>;
template <class T, class Motion>
void correctMotion(Motion& motion, std::array<T, 3>& acceleration_W, std::array<T, 3>& angular_acceleration_W,
                   const BasicAccelerations<T>& end, double dt) {
    motion.velocity_W += 0.5 * dt * (end.linear_W - toVector(acceleration_W));
    motion.angular_velocity_W += 0.5 * dt * (end.angular_W - toVector(angular_acceleration_W));
    acceleration_W = {end.linear_W.x(), end.linear_W.y(), end.linear_W.z()};
    angular_acceleration_W = {end.angular_W.x(), end.angular_W.y(), end.angular_W.z()};
}

// How a wheel turns about its axis, and its axis with it.
template <class T>
struct BasicWheelTurning {
    T inertia;              // kg m2, about the axis
    T spin;                 // rad/s
    T spin_rate;            // rad/s2
    VectorOf<T> carrier_B;  // rad/s, of the carrier in the world
};
using WheelTurning = BasicWheelTurning<double>;
// Moments of the tyre, and the reaction of the spinning wheel: its own acceleration and its gyroscopic couple, which it
// owes to the turning of body and steering.
template <class T>
VectorOf<T> wheelMoment(const BasicWheelContact<T>& contact, const BasicTyreForces<T>& tyre,
                        const BasicWheelTurning<T>& wheel) {
    VectorOf<T> moment = tyre.Mx * contact.forward_B + tyre.My * contact.left_B + tyre.Mz * contact.normal_B;
    moment -= wheel.inertia * wheel.spin_rate * contact.axis_B;
    moment -= wheel.carrier_B.cross(wheel.inertia * wheel.spin * contact.axis_B);
    return moment;
}

// Weight of the body; the wheels' weight along z hangs on their suspension.
template <class T, class Car>
BasicWrench<T> weight(const Car& vehicle, const BasicBodyFrame<T>& body) {
    BasicWrench<T> wrench;
    wrench.force_B = vehicle.params.mass * body.gravity_B;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto& corner = vehicle.corners[i];
        wrench.add(VectorOf<T>(0, 0, -corner.unsprung_mass * body.gravity_B.z()), corner.hub_B);
    }
    return wrench;
}

// What the wheels' weight and inertia along x and y do more where the wheels are than where the mass matrix and
// weight() count them, at static load.
template <class T, class Car>
BasicWrench<T> displacedWheels(const Car& vehicle, const PerWheel<BasicWheelState<T>>& wheels,
                               const BasicBodyFrame<T>& body) {
    using Vector = VectorOf<T>;
    const Vector& w = body.motion.angular_velocity_B;
    const auto accelerationAt = [&](const Vector& point) -> Vector {
        return body.acceleration_B + body.angular_acceleration_B.cross(point) + w.cross(w.cross(point));
    };
    BasicWrench<T> wrench;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto& corner = vehicle.corners[i];
        const Vector there = corner.hub_B + Vector(0, 0, wheels[i].travel);
        const Vector coriolis = 2.0 * w.cross(Vector(0, 0, wheels[i].rate));
        Vector is = corner.unsprung_mass * (body.gravity_B - accelerationAt(there) - coriolis);
        Vector counted = corner.unsprung_mass * (body.gravity_B - accelerationAt(corner.hub_B));
        is.z() = counted.z() = 0;
        wrench.add(is, there);
        wrench.add(-counted, corner.hub_B);
    }
    return wrench;
}

// What one wheel hands to the body: horizontal tyre forces at the contact, suspension and link forces at the hub,
// tyre moments, reaction of the spin.
template <class T, class Corner>
void addWheel(BasicWrench<T>& wrench, const Corner& corner, const BasicWheelContact<T>& contact,
              const BasicTyreForces<T>& tyre, const BasicWheelState<T>& wheel, const T& steer_rate,
              const BasicBodyFrame<T>& body) {
    using Vector = VectorOf<T>;
    const Vector road_force = tyre.Fx * contact.forward_B + tyre.Fy * contact.left_B + wheel.load * contact.normal_B;

    // Along x and y the wheel moves with the body; along z only the suspension and the links push, at the hub. The
    // vertical force acts at the contact, beside the hub: the links carry that couple.
    wrench.add(Vector(road_force.x(), road_force.y(), 0), contact.point_B);
    wrench.add(Vector(0, 0, wheel.suspension_force - wheel.link_force), corner.hub_B);
    const Vector beside(contact.point_B.x() - contact.hub_B.x(), contact.point_B.y() - contact.hub_B.y(), 0);
    wrench.moment_B += beside.cross(Vector(0, 0, road_force.z()));

    wrench.moment_B += wheelMoment<T>(contact, tyre,
                                      {.inertia = corner.wheel_inertia,
                                       .spin = wheel.spin,
                                       .spin_rate = wheel.spin_rate,
                                       .carrier_B = body.motion.angular_velocity_B + Vector(0, 0, steer_rate)});
}

// Aerodynamics, car by car.
template <class T, class Car>
BasicWrench<T> aeroWrench(const Car& vehicle, const BasicBodyFrame<T>& body, const VectorOf<T>& wind_W) {
    using Vector = VectorOf<T>;
    const Vector air_velocity_B = body.motion.velocity_B - transposedTimes<Vector>(body.motion.to_world, wind_W);
    BasicWrench<T> wrench;
    for (std::size_t i = 0; i < kLanesOf<T>; ++i) {
        const AirPush air = airPush(paramsOf(vehicle, i), {lane(air_velocity_B.x(), i), lane(air_velocity_B.y(), i),
                                                           lane(air_velocity_B.z(), i)});
        setLane(wrench.force_B.x(), i, air.force_B[0]);
        setLane(wrench.force_B.y(), i, air.force_B[1]);
        setLane(wrench.force_B.z(), i, air.force_B[2]);
        setLane(wrench.moment_B.x(), i, air.moment_B[0]);
        setLane(wrench.moment_B.y(), i, air.moment_B[1]);
        setLane(wrench.moment_B.z(), i, air.moment_B[2]);
    }
    return wrench;
}

// Replaces the predicted velocities by those that the wrench at the end of the step gives, and keeps the accelerations.
template <class T, class Motion, class State, class Car>
void correct(Motion& motion, State& state, const Car& vehicle, const BasicBodyFrame<T>& body,
             const BasicWrench<T>& wrench, double dt) {
    using Vector = VectorOf<T>;
    const auto& inertia = vehicle.params.inertia;
    const Vector& w = body.motion.angular_velocity_B;
    const Vector spin(inertia.roll * w.x() - inertia.roll_yaw * w.z(), inertia.pitch * w.y(),
                      inertia.yaw * w.z() - inertia.roll_yaw * w.x());
    BasicWrench<T> total = wrench;
    total.moment_B -= w.cross(spin);
    // The centrifugal force of an unsprung mass along z pulls at its spring, not at the body.
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto& corner = vehicle.corners[i];
        const Vector centrifugal = w.cross(w.cross(corner.hub_B));
        total.add(Vector(0, 0, corner.unsprung_mass * centrifugal.z()), corner.hub_B);
    }
    const T load[6]{total.force_B.x(),  total.force_B.y(),  total.force_B.z(),
                    total.moment_B.x(), total.moment_B.y(), total.moment_B.z()};
    T acceleration[6];
    for (int i = 0; i < 6; ++i) {
        acceleration[i] = vehicle.inverse_mass(i, 0) * load[0];
        for (int k = 1; k < 6; ++k) acceleration[i] += vehicle.inverse_mass(i, k) * load[k];
    }
    const Vector linear(acceleration[0], acceleration[1], acceleration[2]);
    const Vector angular(acceleration[3], acceleration[4], acceleration[5]);

    const RotationOf<T>& to_world = body.motion.to_world;
    correctMotion<T>(motion, state.acceleration_W, state.angular_acceleration_W,
                     {times<Vector>(to_world, linear), times<Vector>(to_world, angular)}, dt);

    // The wheels keep their own velocity along z: their travel takes the opposite of the hub's correction.
    const Vector change = linear - body.acceleration_B;
    const Vector turn = angular - body.angular_acceleration_B;
    for (std::size_t i = 0; i < kWheels; ++i)
        state.wheels[i].rate -= 0.5 * dt * Vector(change + turn.cross(vehicle.corners[i].hub_B)).z();
}

}  // namespace TREAD_ISA
}  // namespace tread
