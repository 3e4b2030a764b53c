#include "vehicle/force_command.h"

#include "vehicle/tyre_load.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

// Slip up to which a wheel takes the whole torque: about the peak of a car tyre. It takes none where the tyre slides.
constexpr double kWholeTorque = 0.12;
constexpr double kNoTorque = 0.3;
constexpr double kSlowest = 2;  // m/s; slower cars are allowed the slip speed of this one

// A wheel off the ground has no loaded radius: the distance to the road counts within these shares of the free one.
constexpr double kLeastRadius = 0.5;

double radiusOf(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, std::size_t axle) {
    const double free_radius = vehicle.corners[2 * axle].tyre.parameters.Ro;
    const double radius = 0.5 * (wheels[2 * axle].radius + wheels[2 * axle + 1].radius);
    return std::clamp(radius, kLeastRadius * free_radius, free_radius);
}

// Radius by which a force becomes a torque that the axles share: each axle's part of the force acts at its own wheels.
double leverOf(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, double front_share) {
    const double front = radiusOf(vehicle, wheels, 0), rear = radiusOf(vehicle, wheels, 1);
    return front * rear / (front_share * rear + (1 - front_share) * front);
}

}  // namespace

CommandedTorques commandedTorques(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, double force) {
    CommandedTorques torques;
    if (force >= 0) {
        torques.drive = force * leverOf(vehicle, wheels, vehicle.params.driveline.front_share);
        return torques;
    }
    const double front_share = vehicle.params.brakes.front_share;
    const double half = 0.5 * -force * leverOf(vehicle, wheels, front_share);
    torques.brake = {half * front_share, half * front_share, half * (1 - front_share), half * (1 - front_share)};
    return torques;
}

// The share falls linearly with the slip at the end of the step, where share * torque and the road's force of the last
// step turn the wheel: implicit, so that a long step does not make it jump between both ends.
double takenShare(const WheelState& wheel, const Vehicle::Corner& corner, double torque, double dt) {
    const double rolling_radius = rollingRadius(corner.tyre, wheel.motion.Fz);
    const double speed = wheel.motion.Vx, least = std::max(std::abs(speed), kSlowest);
    const double slip = std::abs(rolling_radius * wheel.spin - speed) / least;
    const double by_torque = rolling_radius * dt / (corner.wheel_inertia * least);
    const double held = by_torque * std::abs(wheel.fx) * wheel.radius;
    return std::clamp((kNoTorque - slip + held) / (kNoTorque - kWholeTorque + by_torque * torque), 0.0, 1.0);
}

}  // namespace tread
