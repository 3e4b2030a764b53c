// The answer of a car to steering over frequency: from a sweep, a pulse or random steering.
#pragma once

#include "log/log.h"
#include "metrics/frequency_curve.h"

namespace tread {

struct SteeringResponse {
    SpectrumSettings settings;
    std::size_t segments;
    double speed;             // m/s
    double largest_ay;        // m/s2
    double from, to;          // Hz: where the steering has power
    FrequencyCurve yaw_rate;  // over the steering-wheel angle, 1/s; from `from` to `to`
    FrequencyCurve ay;        // m/s2 over rad
};

// Throws MetricError when the steering has no broad spectrum.
SteeringResponse steeringResponse(const Log& log);

}  // namespace tread
