// What the driver of the other car does, and what the car does.
#pragma once

#include <array>

namespace other_car {

struct Input {
    double steering_wheel = 0, throttle = 0, brake = 0;
};

// x, y, yaw, vx, vy, yaw rate, roll, roll rate; spins; lateral and longitudinal slips as relaxed; steering and brakes
// as they lag; pitch, pitch rate. Only of some structures: swinging column, rear brake circuit, boost, roll of the rear
// of the body.
enum State {
    kX,
    kY,
    kYaw,
    kVx,
    kVy,
    kYawRate,
    kRoll,
    kRollRate,
    kSpin,
    kAlpha = kSpin + 4,
    kKappa = kAlpha + 4,
    kSteer = kKappa + 4,
    kBrake,
    kPitch,
    kPitchRate,
    kColumn,
    kColumnRate,
    kRearBrake,
    kBoost,
    kRearRoll,
    kRearRollRate,
    kStates
};
using Vector = std::array<double, kStates>;

}  // namespace other_car
