// A commanded longitudinal force, as torques at the wheels: that of a driver who follows a speed exactly, or of an
// automated car. Above zero it drives by the driveline's shares, below zero it brakes by the brake balance. Engine,
// gearbox and pedals do not limit it; the grip of each wheel does.
#pragma once

#include "tread/vehicle.h"

namespace tread {

struct CommandedTorques {
    double drive = 0;          // N m, on all driven wheels together
    PerWheel<double> brake{};  // N m, that each brake can hold
};

// Torques that give the tyres this force [N], positive forward, while no wheel is accelerated.
CommandedTorques commandedTorques(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, double force);

// Share of a commanded torque [N m, not negative] that a wheel takes in a step of dt: 1 while it grips, falling to 0 as
// it spins or locks.
double takenShare(const WheelState& wheel, const Vehicle::Corner& corner, double torque, double dt);

}  // namespace tread
