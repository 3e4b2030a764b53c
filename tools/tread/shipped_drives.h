// The manoeuvres that tread brings along, as far as a diagnosis may advise to drive them.
#pragma once

#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/options.h"

namespace tread::program {

// Those that are found: in this folder, or where the program is built or installed. Each is named as `tread run` takes
// it: "scenarios/step_steer_80.yaml --set scenario.start.speed=30".
std::vector<diagnose::PossibleDrive> shippedDrives();

}  // namespace tread::program
