// Sine steering, after ISO 7401: one period, or continuous.
#pragma once

#include "metrics/metrics.h"

namespace tread {

std::vector<Metric> sineSteerMetrics(const Log& log, const KnownCar& car);

}  // namespace tread
