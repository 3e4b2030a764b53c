// The answer of a car to steering over frequency: from a sweep, a pulse or random steering.
#pragma once

#include <vector>

#include "log/log.h"
#include "metrics/spectrum.h"

namespace tread {

struct SteeringResponse {
    SpectrumSettings settings;
    std::size_t segments;
    double speed;                          // m/s
    double largest_ay;                     // m/s2
    double from, to;                       // Hz: where the steering has power
    std::vector<FrequencyPoint> yaw_rate;  // over the steering-wheel angle, 1/s; from `from` to `to`
    std::vector<FrequencyPoint> ay;        // m/s2 over rad
};

// Throws MetricError when the steering has no broad spectrum.
SteeringResponse steeringResponse(const Log& log);

// Value and phase between the points; NaN values outside.
double gainAt(const std::vector<FrequencyPoint>& points, double frequency);
double phaseLagAt(const std::vector<FrequencyPoint>& points, double frequency);  // rad
double coherenceAt(const std::vector<FrequencyPoint>& points, double frequency);

}  // namespace tread
