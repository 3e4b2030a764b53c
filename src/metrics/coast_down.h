// Coast-down: driving resistance from the deceleration of a car that rolls free.
#pragma once

#include "metrics/metrics.h"

namespace tread {

std::vector<Metric> coastDownMetrics(const Log& log, const KnownCar& car);

}  // namespace tread
