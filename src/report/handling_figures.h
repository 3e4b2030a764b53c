// Figures of steady and transient cornering tests.
#pragma once

#include <optional>
#include <vector>

#include "report/run_report.h"

namespace tread {

// Steering-wheel angle over lateral acceleration, with the line of the gradient that the metrics found (ISO 4138,
// slowly increasing steer).
std::optional<Chart> understeerFigure(const RunReport& content);

// Step steer: steering wheel, yaw rate and lateral acceleration over time as shares of their steady values, with the
// response times that the metrics found (ISO 7401).
std::optional<Chart> stepFigure(const RunReport& content);

// Sine with dwell: steering wheel and yaw rate over time, with the yaw rate that is allowed after completion of steer.
std::vector<Chart> dwellFigures(const Log& log);

}  // namespace tread
