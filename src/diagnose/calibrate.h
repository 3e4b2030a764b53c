// The nominal car with its parameters where the recordings want them, within their tolerances.
#pragma once

#include <functional>

#include "diagnose/study.h"

namespace tread {

// Fills in the study's calibration and the ground about it, from that about the nominal car; and, where the calibrated
// car is likely, noise and disturbances there. Throws SimulationError when the nominal car cannot be driven so.
void calibrate(Study& study, const std::function<void(double)>& progress);

}  // namespace tread
