// Sine with dwell: what is judged and when, for a figure of it.
#pragma once

#include <array>

#include "log/log.h"

namespace tread {

struct YawRateCheck {
    double after;  // s after completion of steer
    double share;  // of the peak, which the yaw rate may at most have then
};
inline constexpr std::array kYawRateChecks{YawRateCheck{1.00, 0.35}, YawRateCheck{1.75, 0.20}};

struct DwellSteering {
    double begin, end;     // s: beginning and completion of steer
    double peak_yaw_rate;  // rad/s, of the second half-wave, with its sign
};

// Throws MetricError when the log holds no sine with dwell.
DwellSteering dwellSteering(const Log& log);

}  // namespace tread
