// Logs in closed form.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "log/csv.h"

namespace tread::cli {

// A car whose yaw rate follows the steering wheel with one lag, turned by a ramp and held.
inline constexpr double kStepBegin = 1;       // s
inline constexpr double kStepDuration = 0.2;  // s
inline constexpr double kStepAngle = 0.5;     // rad
inline constexpr double kLag = 0.15;          // s
inline constexpr double kSpeed = 25;          // m/s
inline constexpr double kYawGain = 0.4;       // 1/s

inline double steering(double t) {
    return kStepAngle * std::fmin(std::fmax((t - kStepBegin) / kStepDuration, 0), 1);
}

inline double yawRate(double t) {
    const double s = t - kStepBegin;
    if (s <= 0) return 0;
    const double on_ramp = (s - kLag * (1 - std::exp(-s / kLag))) / kStepDuration;
    const double held = 1 - kLag / kStepDuration * (std::exp(kStepDuration / kLag) - 1) * std::exp(-s / kLag);
    return kYawGain * kStepAngle * (s < kStepDuration ? on_ramp : held);
}

// From half the steering until 90 % of the steady yaw rate.
inline double yawResponseTime() {
    return kLag * std::log(10 * kLag / kStepDuration * (std::exp(kStepDuration / kLag) - 1)) - kStepDuration / 2;
}

inline Log stepSteer() {
    Log log{{{"time", "s", {}},
             {"driver.steering_wheel_angle", "rad", {}},
             {"chassis.vx", "m/s", {}},
             {"chassis.yaw_rate", "rad/s", {}},
             {"chassis.ay", "m/s2", {}}}};
    for (int i = 0; i <= 600; ++i) {
        const double t = 0.01 * i;
        const double row[] = {t, steering(t), kSpeed, yawRate(t), kSpeed * yawRate(t)};
        for (std::size_t c = 0; c < log.channels.size(); ++c) log.channels[c].values.push_back(row[c]);
    }
    return log;
}

// The same log with one channel changed: `change` takes time and value.
inline Log with(Log log, const std::string& name, const std::function<double(double, double)>& change) {
    for (Channel& channel : log.channels) {
        if (channel.name != name) continue;
        for (std::size_t i = 0; i < channel.values.size(); ++i) {
            channel.values[i] = change(log.channels[0].values[i], channel.values[i]);
        }
    }
    return log;
}

}  // namespace tread::cli
