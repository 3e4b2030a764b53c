// Values of a channel between its samples: linear, and only within the span of its time base.
#pragma once

#include <span>
#include <vector>

namespace tread {

// Value at time t; NaN outside the time base. A sample that is hit exactly is returned as it is, so that a neighbour
// that is not finite does not spread.
double valueAt(std::span<const double> time, std::span<const double> values, double t);

// Values at the times `at` (increasing), NaN where the time base does not reach.
std::vector<double> resample(std::span<const double> time, std::span<const double> values, std::span<const double> at);

}  // namespace tread
