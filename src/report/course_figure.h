// A course between cones from above.
#pragma once

#include <optional>

#include "report/run_report.h"

namespace tread {

// Lanes, cones, the way of the car and its outline; nothing without a course or without the car's place.
std::optional<Chart> courseFigure(const RunReport& content);

}  // namespace tread
