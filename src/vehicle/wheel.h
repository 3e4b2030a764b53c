// One wheel: where it touches the road, its vertical motion on the tyre, and its border with the tyre's axes.
#pragma once

#include "tread/vehicle.h"

namespace tread {

// The body's motion and the surroundings as one wheel sees them, all in body axes.
struct BodyFrame {
    Vector3 velocity_B;
    Vector3 angular_velocity_B;
    Vector3 acceleration_B;  // as it was at the end of the last step
    Vector3 angular_acceleration_B;
    Eigen::Matrix3d to_world;  // body to world
    Vector3 position_W;
    Vector3 gravity_B;
};
BodyFrame bodyFrame(const ChassisMotion& motion, const VehicleState& state, const Vector3& gravity_W);

// Contact of a wheel with the plane of the road, in body axes.
struct WheelContact {
    Vector3 point_B;    // m, contact centre
    Vector3 hub_B;      // m, wheel centre
    Vector3 forward_B;  // unit vectors of the ISO 8855 wheel axes at the contact
    Vector3 left_B;
    Vector3 normal_B;
    Vector3 axis_B;  // of the spin
    double radius;   // m, wheel centre to road
    double camber;   // rad, against the road
    double friction;
    bool exists;
    Vector3 ground_velocity_B;
};
// `displacement` is that of the wheel centre against the body, from where it is at static load.
WheelContact wheelContact(const BodyFrame& body, const Vehicle::Corner& corner, const Vector3& displacement,
                          double camber, double steer, const Road& road, std::size_t wheel);

// Normal load of the tyre (83), and its slopes with deflection and deflection rate.
struct TyreLoad {
    double load;           // N
    double by_deflection;  // N/m
    double by_rate;        // N s/m
};
TyreLoad tyreLoad(const TyreParams& tyre, const WheelContact& contact, const BodyFrame& body, double rate);

// Motion of the tyre in the paper's axes; `slopes` is how the contact moves in the body over the suspension travel,
// `yaw_rate` is that of the wheel relative to the body.
TyreMotion tyreMotion(const WheelContact& contact, const BodyFrame& body, const Vector3& slopes, double rate,
                      double yaw_rate, double load);

// By how much about, and rather too much, the aligning moment falls within a step with the rate at which the wheel is
// turned, N m s/rad: the force (26) accelerates the contact patch, and its motion makes the couple (25).
double turningResistance(const Vehicle::Corner& corner, double spin, double dt);

// Forces of the tyre, converted from the paper's axes to ISO 8855 wheel axes.
TyreForces toIso(const TyreForces& paper);

}  // namespace tread
