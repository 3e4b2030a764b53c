// A parked car: how well it stands still.
#pragma once

#include "metrics/metrics.h"

namespace tread {

std::vector<Metric> parkedMetrics(const Log& log, const KnownCar& car);

}  // namespace tread
