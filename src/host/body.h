// The host's own rigid body as the chassis of the car.
//
// The car is advanced on a motion of its own through one step of the host, from where the host's body is. The body is
// then given the constant force and moment that take it through the same motion. What else acts on it (collisions, a
// trailer, a crane) shows at the next step as another velocity than the one that was expected.
#pragma once

#include "tread/vehicle.h"

namespace tread::host {

// How the host moves a body under a force that it holds over its step.
enum class Integration {
    // So that the velocity changes by acceleration times step, as it does for an integrator of order two or higher. The
    // motion of the body is then that of the car to second order in the step. The host has gyroscopic moments.
    exact,
    // Velocity first, then the position with the new velocity, as in most game engines, which have no gyroscopic
    // moments. The body shows the mean velocity of its last step; its pose is exactly that of the car, as in Bullet.
    semi_implicit
};

// What a host makes its body of.
struct BodyProperties {
    double mass;                // kg, of the whole car with its load
    Eigen::Matrix3d inertia_B;  // kg m2, of the whole car about its centre of gravity
    Vector3 reference_B;        // m, point to which the chassis outputs refer, from the centre of gravity
};
BodyProperties bodyProperties(const Vehicle& vehicle);

// On the body at its centre of gravity, constant over the step; without its weight, which the host adds.
struct BodyForce {
    Vector3 force_W = Vector3::Zero();                 // N
    Vector3 moment_W = Vector3::Zero();                // N m
    Vector3 acceleration_W = Vector3::Zero();          // m/s2, that force and weight together give
    Vector3 angular_acceleration_W = Vector3::Zero();  // rad/s2, by which the body's angular velocity has to change
};

// The velocities that the host's body will show if nobody else pushes it.
struct BodyLink {
    Vector3 velocity_W = Vector3::Zero();
    Vector3 angular_velocity_W = Vector3::Zero();
};

// The motion of the car from which the next step starts: pose of the body, velocity that the car had (`last`) with what
// others have changed of the body's.
ChassisMotion taken(const ChassisMotion& body, const ChassisMotion& last, const BodyLink& link);

// Force that takes the body, of the velocities `shown`, from one motion to the other; `link` is set to what it will
// show then.
BodyForce forceBetween(const ChassisMotion& from, const ChassisMotion& to, const ChassisMotion& shown,
                       const BodyProperties& body, Integration integration, const Vector3& gravity_W, double dt,
                       BodyLink& link);

}  // namespace tread::host
