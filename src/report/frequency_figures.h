// Bode plots of the answer to steering.
#pragma once

#include <vector>

#include "log/log.h"
#include "report/svg.h"

namespace tread {

// Gains, phase and coherence of yaw rate and lateral acceleration; none when the steering has no broad spectrum.
std::vector<Chart> frequencyFigures(const Log& log);

}  // namespace tread
