// Side wind at fixed steering, after ISO 12021: how far the car is blown off its line.

#include <fmt/format.h>

#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kWindReading = 2.0;     // s after the wind
constexpr double kOnset = 0.1;           // of the largest lateral acceleration
constexpr double kLeastGust = 0.1;       // m/s2: less is no gust
constexpr double kStraightBefore = 0.5;  // s of driving straight on
constexpr double kStraight = 0.1;        // m/s2 of lateral acceleration before

struct Crosswind {
    double onset;               // s
    double deviation;           // m, to the side to which the wind blows
    double yaw, peak_yaw_rate;  // rad, rad/s, signs of that side
    double peak_ay, speed;
};

MetricTable<Crosswind> crosswindTable() {
    const std::string reading = fmt::format("{:.0f} s after the wind begins", kWindReading);
    return {
        {{"path_deviation", "Path deviation", "m",
          "distance from the initial line, " + reading + ", positive in the direction in which the wind pushes",
          Say{1, "{} m off its line after 2 s", 2}},
         [](const Crosswind& c) { return c.deviation; }},
        {{"yaw_angle", "Yaw angle", "deg", "change of heading, " + reading + "; negative: the car turns into the wind"},
         [](const Crosswind& c) { return kDegrees * c.yaw; }},
        {{"peak_yaw_rate", "Yaw rate, peak", "deg/s",
          "largest yaw rate up to then, positive in the direction in which the wind pushes",
          Say{2, "turns at up to {} deg/s", 2}},
         [](const Crosswind& c) { return kDegrees * c.peak_yaw_rate; }},
        {{"peak_ay", "Lateral acceleration, peak", "m/s2", "largest lateral acceleration up to then",
          Say{3, "peak lateral acceleration {} m/s2", 2}},
         [](const Crosswind& c) { return c.peak_ay; }},
        {{"speed", "Speed", "m/s", "speed when the wind begins"}, [](const Crosswind& c) { return c.speed; }},
    };
}

double farthest(const TimeSeries& series, double from, double to) {
    const double high = highest(series, from, to).value, low = lowest(series, from, to).value;
    return std::abs(high) > std::abs(low) ? high : low;
}

Crosswind findCrosswind(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.x", "chassis.y", "chassis.yaw",
                                       "chassis.yaw_rate", "chassis.ay"});
    const TimeSeries yaw_rate = cleaned(needed[4], kResponseHalfWidth), ay = cleaned(needed[5], kResponseHalfWidth);
    const TimeSeries& hand = needed[0];
    if (const double moved = range(hand).width(); moved > kFixedSteering) {
        notFound(fmt::format("the steering wheel moves by {:.2g} deg, expected fixed steering", kDegrees * moved));
    }
    const double largest = farthest(ay, ay.begin(), ay.end());
    if (std::abs(largest) < kLeastGust) {
        notFound(fmt::format("the lateral acceleration stays below {:.2g} m/s2", kLeastGust));
    }
    const auto onset = firstCrossing(ay, kOnset * largest, ay.begin());
    if (!onset || *onset - ay.begin() < kStraightBefore || std::abs(farthest(ay, ay.begin(), *onset - 0.2)) > kStraight)
        notFound(fmt::format("the car does not drive straight ahead for the first {:.2g} s", kStraightBefore));
    const double then = *onset + kWindReading;
    if (then > ay.end()) notFound(fmt::format("the log ends before {:.0f} s after the wind", kWindReading));

    const double side = largest > 0 ? 1 : -1, heading = mean(needed[3], *onset - kStraightBefore, *onset);
    const double dx = at(needed[1], then) - at(needed[1], *onset), dy = at(needed[2], then) - at(needed[2], *onset);
    return {.onset = *onset,
            .deviation = side * (dy * std::cos(heading) - dx * std::sin(heading)),
            .yaw = side * (at(needed[3], then) - heading),
            .peak_yaw_rate = side * farthest(yaw_rate, *onset, then),
            .peak_ay = side * farthest(ay, *onset, then),
            .speed = at(speed(log), *onset)};
}

}  // namespace

Manoeuvre crosswind() {
    return {"crosswind", "side wind at fixed steering: path, heading and yaw rate (after ISO 12021)",
            [] { return definitions(crosswindTable()); },
            [](const Log& log, const KnownCar&) { return values(crosswindTable(), findCrosswind(log)); }};
}

}  // namespace tread
