// Inputs and states of the other car.
#pragma once

#include <array>

namespace other_car {

struct Input {
    double steering_wheel = 0, throttle = 0, brake = 0;
};

// Position, velocity and attitude of the body; spin, relaxed lateral and longitudinal slip of four wheels; lagged
// steering wheel and brake pedal; pitch. In some structures only: steering column, rear brake circuit, boost, roll of
// the rear part of the body. SI units.
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
