// One wheel of the car: its frame of reference, its contact with the road, its load.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/contact.h"
#include "vehicle/tyre_load.h"

namespace tread {

// The body's motion and the surroundings as one wheel sees them, all in body axes.
struct BodyFrame {
    BodyMotion motion;
    Vector3 acceleration_B;  // as it was at the end of the last step
    Vector3 angular_acceleration_B;
    Vector3 gravity_B;
};
BodyFrame bodyFrame(const ChassisMotion& motion, const VehicleState& state, const Vector3& gravity_W);

// How the suspension holds a wheel against the body.
struct WheelPose {
    Vector3 displacement_B;  // m, of the wheel centre, from where it is at static load
    double camber;           // rad, rotation about x
    double steer;            // rad, then about z
};
WheelContact wheelContact(const BodyFrame& body, const Vehicle::Corner& corner, const WheelPose& pose, const Road& road,
                          std::size_t wheel);

// Load of a wheel whose travel grows at `rate`.
TyreLoad tyreLoad(const Vehicle::Corner& corner, const WheelContact& contact, const BodyFrame& body, double rate);

// `slopes` is how the contact moves in the body over the suspension travel, `yaw_rate` the steering rate of the wheel.
TyreMotion tyreMotion(const WheelContact& contact, const BodyFrame& body, const Vector3& slopes, double rate,
                      double yaw_rate, double load);

// By how much about, and rather too much, the aligning moment falls within a step with the rate at which the wheel is
// turned, N m s/rad: the force (26) accelerates the contact patch, and its motion makes the couple (25).
double turningResistance(const Vehicle::Corner& corner, double spin, double dt);

}  // namespace tread
