// Steady-state cornering, after ISO 4138: constant radius, constant speed or constant steering angle.
#pragma once

#include "metrics/metrics.h"

namespace tread {

std::vector<Metric> steadyCircleMetrics(const Log& log, const KnownCar& car);

}  // namespace tread
