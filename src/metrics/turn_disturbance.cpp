#include "metrics/turn_disturbance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kSteadyBefore = 0.5;   // s of steady turn before the onset
constexpr double kTurnReading = 1.0;    // s after the onset, at which the standards read
constexpr double kTurnHalfWidth = 0.1;  // s
constexpr double kSlowestTurn = 3;      // m/s
constexpr double kLeastTurn = 1;        // m/s2: less is no turn
constexpr double kSteady = 0.1;         // change of the yaw rate over the time before, as a share
constexpr double kSlowestRatio = 2;     // m/s: below, no ratio to a turn is formed

// Distance from the circle on which the car was, positive inwards.
double deviation(const Log& log, const TurnDisturbance& d, double direction, double time) {
    const auto x = channelIfThere(log, "chassis.x"), y = channelIfThere(log, "chassis.y"),
               yaw = channelIfThere(log, "chassis.yaw");
    if (!x || !y || !yaw) return kUndefined;
    const auto slip = sideslip(log);
    const double course = at(*yaw, d.onset) + (slip ? at(*slip, d.onset) : 0);
    const double cx = at(*x, d.onset) - direction * d.radius * std::sin(course);
    const double cy = at(*y, d.onset) + direction * d.radius * std::cos(course);
    return d.radius - std::hypot(at(*x, time) - cx, at(*y, time) - cy);
}

}  // namespace

TurnDisturbance turnDisturbance(const Log& log, double onset, double end) {
    const auto needed = channels(log, {"chassis.vx", "chassis.yaw_rate", "chassis.ay", "driver.steering_wheel_angle"});
    const TimeSeries v = cleaned(speed(log), kTurnHalfWidth);
    const TimeSeries yaw_rate = cleaned(needed[1], kTurnHalfWidth), ay = cleaned(needed[2], kTurnHalfWidth);
    const double from = onset - kSteadyBefore;
    TurnDisturbance d{};
    d.onset = onset;
    d.speed = mean(v, from, onset);
    d.ay = mean(ay, from, onset);
    d.steering = mean(needed[3], from, onset);
    const double rate = mean(yaw_rate, from, onset), direction = rate < 0 ? -1 : 1;
    if (d.speed < kSlowestTurn || std::abs(rate) * d.speed < kLeastTurn) {
        notFound(
            fmt::format("the car first turns at {:.2g} m/s2 at {:.3g} m/s, expected a turn of at least {:.2g} m/s2",
                        std::abs(rate) * d.speed, d.speed, kLeastTurn));
    }
    const TimeSeries before = part(yaw_rate, from, onset);
    const double drift = std::abs(fitLine(before.time, before.value).slope * kSteadyBefore / rate);
    if (onset - yaw_rate.begin() < kSteadyBefore || drift > kSteady) {
        notFound(fmt::format("the yaw rate changes by {:.0f} % over the preceding {:.2g} s, expected a steady turn",
                             100 * drift, kSteadyBefore));
    }
    d.radius = std::abs(d.speed / rate);

    const double reading = onset + kTurnReading;
    const bool lasts = reading <= v.end();
    const auto then = [&](double value) { return lasts ? value : kUndefined; };
    const double v_then = at(v, reading);
    const bool moving = v_then > kSlowestRatio;
    d.deceleration = then((d.speed - v_then) / kTurnReading);
    d.yaw_rate_ratio = then(moving ? direction * at(yaw_rate, reading) * d.radius / v_then : kUndefined);
    d.ay_ratio = then(moving ? direction * at(ay, reading) * d.radius / (v_then * v_then) : kUndefined);
    d.yaw_acceleration = then(direction * (at(yaw_rate, onset + 0.5) - rate) / 0.5);
    const auto slip = sideslip(log);
    d.sideslip_change = then(slip ? -direction * (at(*slip, reading) - mean(*slip, from, onset)) : kUndefined);
    d.path_deviation = then(deviation(log, d, direction, reading));
    for (std::size_t i = 0; i < yaw_rate.size(); ++i) {
        const double t = yaw_rate.time[i];
        if (t < onset || t > end || v.value[i] < kSlowestRatio) continue;
        d.peak_yaw_ratio = std::max(d.peak_yaw_ratio, direction * yaw_rate.value[i] * d.radius / v.value[i]);
    }
    d.steering_range = range(part(needed[3], onset, end)).width();
    return d;
}

MetricTable<TurnDisturbance> turnDisturbanceTable(const std::string& foot, const Say& deceleration,
                                                  const Say& sideslip) {
    const std::string reading = fmt::format("{:.0f} s after the {}", kTurnReading, foot);
    return {
        {{"yaw_rate_ratio", "Yaw rate over that at the initial radius", "-",
          "yaw rate over speed / initial radius, " + reading,
          Say{2, "turns {} times as fast as the circle requires after 1 s", 2}},
         [](const TurnDisturbance& d) { return d.yaw_rate_ratio; }},
        {{"ay_ratio", "Lateral acceleration over that at the initial radius", "-",
          "lateral acceleration over speed^2 / initial radius, " + reading},
         [](const TurnDisturbance& d) { return d.ay_ratio; }},
        {{"mean_deceleration", "Deceleration, mean", "m/s2", "loss of speed over time up to " + reading, deceleration},
         [](const TurnDisturbance& d) { return d.deceleration; }},
        {{"path_deviation", "Path deviation", "m",
          "distance from the circle " + reading + ", positive inwards; undefined without position and heading",
          Say{4, "{} m inside of the circle", 2}},
         [](const TurnDisturbance& d) { return d.path_deviation; }},
        {{"sideslip_change", "Sideslip angle, change", "deg",
          "change of the sideslip angle up to " + reading + ", positive when the tail goes out", sideslip},
         [](const TurnDisturbance& d) { return kDegrees * d.sideslip_change; }},
        {{"yaw_acceleration", "Yaw acceleration", "deg/s2",
          "mean over the first 0.5 s after the " + foot + ", positive into the turn"},
         [](const TurnDisturbance& d) { return kDegrees * d.yaw_acceleration; }},
        {{"peak_yaw_rate_ratio", "Yaw rate over that at the initial radius, peak", "-",
          "largest yaw rate over speed / initial radius, to the end of the manoeuvre"},
         [](const TurnDisturbance& d) { return d.peak_yaw_ratio; }},
        {{"speed", "Speed before", "m/s", "mean over the half second before"},
         [](const TurnDisturbance& d) { return d.speed; }},
        {{"ay", "Lateral acceleration before", "m/s2", "lateral acceleration, mean over the half second before"},
         [](const TurnDisturbance& d) { return d.ay; }},
        {{"radius", "Radius before", "m", "speed over yaw rate, means over the half second before"},
         [](const TurnDisturbance& d) { return d.radius; }},
        {{"steering_range", "Steering-wheel range", "deg",
          "range of the steering-wheel angle from then to the end of the manoeuvre"},
         [](const TurnDisturbance& d) { return kDegrees * d.steering_range; }},
    };
}

}  // namespace tread
