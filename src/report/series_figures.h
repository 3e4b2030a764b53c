// Metrics of a series over the number that is varied.
#pragma once

#include <string>
#include <vector>

#include "report/series_report.h"
#include "report/svg.h"

namespace tread {

// "phases.1.steering.sine_with_dwell.amplitude" -> "amplitude".
std::string variedInWords(const std::string& path);

// One chart for each of the most telling metrics: those with conditions or with limits of a standard first, then those
// that are said. The limits are drawn, and runs that pass are told from those that do not.
std::vector<Chart> seriesFigures(const SeriesReport& content);

}  // namespace tread
