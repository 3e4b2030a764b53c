// Braking over the distance from the brake pedal on.
#pragma once

#include <vector>

#include "report/run_report.h"

namespace tread {

// Speed, deceleration (with the mean fully developed one) and the slip of each wheel; none when nothing brakes.
std::vector<Chart> brakingFigures(const RunReport& content);

}  // namespace tread
