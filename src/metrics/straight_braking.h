// Braking in a straight line: stopping distance and mean fully developed deceleration, after UN R13-H and ISO 21994.
#pragma once

#include "metrics/metrics.h"

namespace tread {

std::vector<Metric> straightBrakingMetrics(const Log& log, const KnownCar& car);

}  // namespace tread
