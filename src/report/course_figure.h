// A course from above: lanes between cones, or a path.
#pragma once

#include <optional>

#include "report/run_report.h"

namespace tread {

// Lanes, cones, the way of the car and its outline; of a path that and the way of the car; nothing without a course or
// without the car's place.
std::optional<Chart> courseFigure(const RunReport& content);

}  // namespace tread
