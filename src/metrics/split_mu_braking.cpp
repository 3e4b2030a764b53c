// Braking with unequal friction under left and right wheels, after ISO 14512 and the split test of UN R13-H: what the
// driver has to steer against, and how the car stops.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"
#include "metrics/stop.h"

namespace tread {
namespace {

constexpr double kFirstCorrection = 2;            // s, of the first correction
constexpr double kSlow = 1;                       // m/s: below, steering and yaw rate tell nothing
constexpr double kLeastSplitTurn = 2 / kDegrees;  // rad, of steering wheel or car: less is straight braking

struct SplitMu {
    Stop stop;
    double mfdd, deviation;  // m/s2, m
    double first, steering;  // rad
    double yaw_rate, yaw;    // rad/s, rad
};

MetricTable<SplitMu> splitMuBrakingTable() {
    const std::string slow = fmt::format(", down to {:.0f} m/s", kSlow);
    return {
        {{"steering_first_2s", "Steering correction in the first 2 s", "deg",
          fmt::format("largest turn of the steering wheel from its angle at brake actuation, in the first {:.0f} s",
                      kFirstCorrection),
          Say{1, "the driver corrects by {} deg in the first 2 s", 0}},
         [](const SplitMu& s) { return kDegrees * s.first; }},
        {{"largest_steering", "Steering correction, maximum", "deg", "the same over the whole stop" + slow},
         [](const SplitMu& s) { return kDegrees * s.steering; }},
        {{"initial_speed", "Initial speed", "m/s", "speed when the driver starts to actuate the brake"},
         [](const SplitMu& s) { return s.stop.initial_speed; }},
        {{"stopping_distance", "Stopping distance", "m", "distance from the start of brake actuation to standstill"},
         [](const SplitMu& s) { return s.stop.distance; }},
        {{"mfdd", "Deceleration, mean fully developed", "m/s2",
          "mean fully developed deceleration: (vb^2 - ve^2) / (2 (se - sb)), vb = 0.8 v0, ve = 0.1 v0",
          Say{3, "MFDD {} m/s2", 2}},
         [](const SplitMu& s) { return s.mfdd; }},
        {{"lateral_deviation", "Lateral deviation", "m",
          "largest distance from the line along which the car pointed at brake actuation; left is positive"},
         [](const SplitMu& s) { return s.deviation; }},
        {{"largest_yaw_rate", "Yaw rate, maximum", "deg/s", "largest magnitude of the yaw rate" + slow},
         [](const SplitMu& s) { return kDegrees * s.yaw_rate; }},
        {{"largest_yaw_angle", "Yaw angle, maximum", "deg",
          "largest turn of the car from its heading at brake actuation" + slow, Say{2, "the car turns by {} deg", 1}},
         [](const SplitMu& s) { return kDegrees * s.yaw; }},
    };
}

// Largest distance from the value at the beginning.
double largestMove(const TimeSeries& series, double from, double to) {
    const double start = at(series, from);
    return std::max(highest(series, from, to).value - start, start - lowest(series, from, to).value);
}

SplitMu findSplitMu(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.yaw_rate", "chassis.yaw"});
    const Stop stop = findStop(log);
    expectNoTurn(log, stop);
    const TimeSeries hand = cleaned(needed[0], kResponseHalfWidth), turning = cleaned(needed[1], kResponseHalfWidth);
    const TimeSeries v = cleaned(speed(log), kSpeedHalfWidth);
    const double end = firstCrossing(v, kSlow, stop.start).value_or(stop.end);
    SplitMu found{
        .stop = stop,
        .mfdd = meanFullyDeveloped(v, stop),
        .deviation = lateralDeviation(log, stop),
        .first = largestMove(hand, stop.start, std::min(end, stop.start + kFirstCorrection)),
        .steering = largestMove(hand, stop.start, end),
        .yaw_rate = std::max(highest(turning, stop.start, end).value, -lowest(turning, stop.start, end).value),
        .yaw = largestMove(needed[2], stop.start, end)};
    if (std::max(found.steering, found.yaw) < kLeastSplitTurn) {
        notFound(
            fmt::format("while braking the steering wheel turns by {:.2g} deg and the car by only {:.2g} "
                        "deg, expected at least {:.2g} deg of one",
                        kDegrees * found.steering, kDegrees * found.yaw, kDegrees * kLeastSplitTurn));
    }
    return found;
}

}  // namespace

Manoeuvre splitMuBraking() {
    return {"split_mu_braking", "braking with unequal friction left and right (after ISO 14512)",
            [] { return definitions(splitMuBrakingTable()); },
            [](const Log& log, const KnownCar&) { return values(splitMuBrakingTable(), findSplitMu(log)); }};
}

}  // namespace tread
