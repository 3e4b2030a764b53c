// The replay of a drive that begins in a turn: a car cannot start there, so it is brought there before time 0.
#pragma once

#include <span>

#include "scenario/scenario.h"

namespace tread {

// Whether a drive of that speed [m/s] turns from its first moment on; yaw rate [rad/s] over time [s].
bool beginsInTurn(double speed, std::span<const double> time, std::span<const double> yaw_rate);

// Puts a phase in front that turns the steering wheel to where the first one finds it, and sets start.run_in to its
// length.
void runIntoTurn(Scenario& scenario);

}  // namespace tread
