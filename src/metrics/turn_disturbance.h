// A steady turn that is disturbed by a foot, brake or throttle: what becomes of it, over the turn that the car would go
// on with if it kept its radius.
#pragma once

#include <optional>
#include <string>

#include "log/log.h"
#include "metrics/metric_table.h"

namespace tread {

struct TurnDisturbance {
    // Before.
    double onset;     // s, of the foot
    double speed;     // m/s
    double ay;        // m/s2
    double radius;    // m, positive
    double steering;  // rad, of the steering wheel
    // A second after the onset; NaN when the log ends before.
    double deceleration;      // m/s2, mean
    double yaw_rate_ratio;    // -, over v(t) / radius
    double ay_ratio;          // -, over v(t)^2 / radius
    double yaw_acceleration;  // rad/s2, mean over half a second, positive into the turn
    double sideslip_change;   // rad, positive when the tail goes out
    double path_deviation;    // m, from the circle, positive inwards
    // From the onset to the end of the manoeuvre.
    double peak_yaw_ratio;  // -, largest yaw rate over v(t) / radius
    double steering_range;  // rad
};

// `end` closes the manoeuvre. Throws MetricError when the car does not turn steadily before the onset.
TurnDisturbance turnDisturbance(const Log& log, double onset, double end);

MetricTable<TurnDisturbance> turnDisturbanceTable(const std::string& foot, const Say& deceleration,
                                                  const Say& sideslip);

}  // namespace tread
