// Where model and car differ: by channel, recording, phase of the manoeuvre, frequency band and operating regime.
#pragma once

#include "diagnose/explain/missing_force.h"

namespace tread::diagnose::explain {

// Shares of the squared gap in excess of noise and disturbances (D46).
answer::WhereItLies whereItLies(const Calibration& car, const MissingForce& missing);

}  // namespace tread::diagnose::explain
