// The body of the car as one rigid mass on which the wheels push: prediction and correction of its motion.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/wheel.h"

namespace tread {

// How states keep a vector: trivially copyable.
inline std::array<double, 3> toArray(const Vector3& v) {
    return {v.x(), v.y(), v.z()};
}

// Force at the centre of gravity and moment about it, body axes.
struct Wrench {
    Vector3 force_B = Vector3::Zero();
    Vector3 moment_B = Vector3::Zero();

    void add(const Vector3& force, const Vector3& at) {
        force_B += force;
        moment_B += at.cross(force);
    }
    void add(const Wrench& other) {
        force_B += other.force_B;
        moment_B += other.moment_B;
    }
};

// Position and attitude after dt, velocities predicted with the accelerations of the last step.
ChassisMotion predicted(const ChassisMotion& from, const std::array<double, 3>& acceleration_W,
                        const std::array<double, 3>& angular_acceleration_W, double dt);

// Replaces the predicted velocities by those that the accelerations at the end of the step give, and keeps these in
// place of the last ones.
struct Accelerations {
    Vector3 linear_W;   // m/s2, of the centre of gravity
    Vector3 angular_W;  // rad/s2
};
void correct(ChassisMotion& motion, std::array<double, 3>& acceleration_W,
             std::array<double, 3>& angular_acceleration_W, const Accelerations& end, double dt);

// How a wheel turns about its axis, and its axis with it.
struct WheelTurning {
    double inertia;     // kg m2, about the axis
    double spin;        // rad/s
    double spin_rate;   // rad/s2
    Vector3 carrier_B;  // rad/s, of the carrier in the world
};
// Moments of the tyre, and the reaction of the spinning wheel: its own acceleration and its gyroscopic couple, which it
// owes to the turning of body and steering.
inline Vector3 wheelMoment(const WheelContact& contact, const TyreForces& tyre, const WheelTurning& wheel) {
    Vector3 moment = tyre.Mx * contact.forward_B + tyre.My * contact.left_B + tyre.Mz * contact.normal_B;
    moment -= wheel.inertia * wheel.spin_rate * contact.axis_B;
    moment -= wheel.carrier_B.cross(wheel.inertia * wheel.spin * contact.axis_B);
    return moment;
}

// Weight of the body; the wheels' weight along z hangs on their suspension.
Wrench weight(const Vehicle& vehicle, const BodyFrame& body);

// What the wheels' weight and inertia along x and y do more where the wheels are than where the mass matrix and
// weight() count them, at static load.
Wrench displacedWheels(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, const BodyFrame& body);

Wrench aeroWrench(const Vehicle& vehicle, const BodyFrame& body, const Vector3& wind_W);

// What one wheel hands to the body: horizontal tyre forces at the contact, suspension and link forces at the hub,
// tyre moments, reaction of the spin.
struct WheelAction {
    const Vehicle::Corner& corner;
    const WheelContact& contact;
    TyreForces tyre;          // ISO 8855 wheel axes
    double load;              // N
    double suspension_force;  // N, up on the body
    double link_force;        // N, up on the wheel
    double spin;              // rad/s
    double spin_rate;         // rad/s2
    double steer_rate;        // rad/s, against the body
};
void addWheel(Wrench& wrench, const WheelAction& wheel, const BodyFrame& body);

// Replaces the predicted velocities by those that the wrench at the end of the step gives, and keeps the accelerations.
void correct(ChassisMotion& motion, VehicleState& state, const Vehicle& vehicle, const BodyFrame& body,
             const Wrench& wrench, double dt);

}  // namespace tread
