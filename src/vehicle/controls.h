// What a driver works, of one car: steering; driveline and brakes with their controllers. They decide and switch, and
// cost little: cars in lanes are handled here one after the other.
#pragma once

#include "tread/vehicle.h"

namespace tread {

// What the road does to the front wheels, at the beginning of the step.
struct FrontWheels {
    struct Forces {
        double fx, fy, mz;  // N, N m, ISO 8855 wheel axes
    };
    Forces left, right;
    double turning_resistance;  // N m s/rad, of both (wheel.h)
};
SteeringMotion steer(SteeringState& state, const Vehicle& vehicle, const FrontWheels& wheels, const VehicleInput& begin,
                     const VehicleInput& end, double dt);

// What driveline, brakes and their controllers see of the car.
struct CarSeen {
    PerWheel<double> spin{};          // rad/s
    PerWheel<double> spin_rate{};     // rad/s2, over the last step
    PerWheel<double> drive_torque{};  // N m, of the last step
    PerWheel<double> speed{};         // m/s, along the heading of each wheel
    double lateral_acceleration;      // m/s2
    double forward_speed;             // m/s
    double yaw_rate;                  // rad/s
    double steer;                     // rad, mean of the front wheels
};
struct WheelTorques {
    PerWheel<double> drive;
    BrakeTorques brake;
};
WheelTorques driveAndBrake(VehicleState& state, const Vehicle& vehicle, const CarSeen& seen, const VehicleInput& begin,
                           const VehicleInput& end, double dt);

}  // namespace tread
