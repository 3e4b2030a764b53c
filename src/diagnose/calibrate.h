// The nominal car with its parameters where the recordings want them, within their tolerances: the car about which
// effects are sought.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnose/study.h"

namespace tread {

// Fills in the study's calibration, the ground about it, and noise and disturbances there. Returns everything() of that
// ground. `nominal`: about the nominal car. Throws SimulationError when the nominal car cannot be driven so.
std::vector<DriveGram> calibrate(Study& study, Ground nominal,
                                 const std::function<void(double, const std::string&)>& progress);

// The drives about the calibration with the columns of all knobs besides those of the nuisances. Knobs that move
// nothing but uncertain numbers are mixtures of the nuisances' columns and are not driven.
Linearised withKnobs(Study& study, const Linearised& nuisances, const std::function<void(double)>& progress);

}  // namespace tread
