// Step steer, after ISO 7401.
#pragma once

#include "metrics/metrics.h"

namespace tread {

std::vector<Metric> stepSteerMetrics(const Log& log, const KnownCar& car);

}  // namespace tread
