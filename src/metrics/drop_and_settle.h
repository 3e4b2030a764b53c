// A car dropped onto its wheels: bounce frequency and damping of the body.
#pragma once

#include "metrics/metrics.h"

namespace tread {

std::vector<Metric> dropAndSettleMetrics(const Log& log, const KnownCar& car);

}  // namespace tread
