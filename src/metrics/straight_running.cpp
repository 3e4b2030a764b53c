// Straight on with the steering wheel held: how far the car drifts off, as on a crowned road or with tyres that pull.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"

namespace tread {
namespace {

constexpr double kShortestStraight = 50;  // m
constexpr double kConstantSpeed = 0.1;    // share by which the speed may change
constexpr double kGentle = 2;             // m/s2 of lateral acceleration
constexpr double kAtFirst = 0.2;          // s that tell the first line
constexpr double kAtLast = 1;             // s

struct StraightRunning {
    double drift, distance;  // m
    double yaw;              // rad
    double yaw_rate, ay;     // at last
    double hand_torque;      // N m, at last
    double speed;
};

MetricTable<StraightRunning> straightRunningTable() {
    return {
        {{"drift", "Drift", "m", "distance from the initial line at the end, positive to the left",
          Say{1, "drifts by {} m", 2}},
         [](const StraightRunning& s) { return s.drift; }},
        {{"drift_per_100m", "Drift over 100 m", "m",
          "the same, scaled to a drive of 100 m with the square of the distance"},
         [](const StraightRunning& s) { return s.drift * std::pow(100 / s.distance, 2); }},
        {{"distance", "Distance", "m", "distance along the initial line"},
         [](const StraightRunning& s) { return s.distance; }},
        {{"yaw_angle", "Yaw angle", "deg", "change of heading"},
         [](const StraightRunning& s) { return kDegrees * s.yaw; }},
        {{"last_yaw_rate", "Yaw rate at the end", "deg/s", fmt::format("mean of the last {:.0f} s", kAtLast)},
         [](const StraightRunning& s) { return kDegrees * s.yaw_rate; }},
        {{"last_ay", "Lateral acceleration at the end", "m/s2",
          fmt::format("mean lateral acceleration of the last {:.0f} s", kAtLast), Say{2, "{} m/s2 at the end", 3}},
         [](const StraightRunning& s) { return s.ay; }},
        {{"hand_torque", "Steering-wheel torque", "N m",
          "torque of the driver who holds the wheel, mean over the same time, positive to the left",
          Say{3, "{} N m at the steering wheel", 2}},
         [](const StraightRunning& s) { return s.hand_torque; }},
        {{"speed", "Speed, mean", "m/s", "mean"}, [](const StraightRunning& s) { return s.speed; }},
    };
}

StraightRunning findStraightRunning(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.x", "chassis.y", "chassis.yaw",
                                       "chassis.yaw_rate", "chassis.ay", "chassis.vx"});
    const TimeSeries &hand = needed[0], &x = needed[1], &y = needed[2];
    const double begin = x.begin(), end = x.end(), late = std::max(begin, end - kAtLast);
    if (range(hand).width() > kFixedSteering) {
        notFound(fmt::format("the steering wheel turns by {:.2g} deg, expected a fixed one",
                             kDegrees * range(hand).width()));
    }
    const double speed = mean(needed[6], begin, end);
    if (!(speed > 0) || range(needed[6]).width() > kConstantSpeed * speed)
        notFound(fmt::format("the speed changes by {:.2g} m/s, expected a constant one", range(needed[6]).width()));
    const double push = std::max(highest(needed[5], begin, end).value, -lowest(needed[5], begin, end).value);
    if (push > kGentle)
        notFound(
            fmt::format("the lateral acceleration reaches {:.2g} m/s2, expected at most {:.2g} m/s2", push, kGentle));

    const double heading = mean(needed[3], begin, begin + kAtFirst);
    const double dx = at(x, end) - at(x, begin), dy = at(y, end) - at(y, begin);
    const double distance = dx * std::cos(heading) + dy * std::sin(heading);
    if (distance < kShortestStraight)
        notFound(fmt::format("the car drives {:.2g} m, expected at least {:.2g} m", distance, kShortestStraight));
    const auto torque = channelIfThere(log, "steering.torque");
    return {.drift = dy * std::cos(heading) - dx * std::sin(heading),
            .distance = distance,
            .yaw = at(needed[3], end) - heading,
            .yaw_rate = mean(needed[4], late, end),
            .ay = mean(needed[5], late, end),
            .hand_torque = torque ? mean(*torque, late, end) : kUndefined,
            .speed = speed};
}

}  // namespace

Manoeuvre straightRunning() {
    return {"straight_running", "straight on with the steering wheel held: drift, pull at the steering wheel",
            [] { return definitions(straightRunningTable()); },
            [](const Log& log, const KnownCar&) { return values(straightRunningTable(), findStraightRunning(log)); }};
}

}  // namespace tread
