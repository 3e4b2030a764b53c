// A parked car: how well it stands still.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"

namespace tread {
namespace {

constexpr double kSettling = 1.0;          // s at the beginning, in which the car may sink into its springs
constexpr double kShortestStanding = 1.0;  // s of standing after that
constexpr double kFastestParked = 0.3;     // m/s: more is no parked car
constexpr double kMinute = 60;             // s

struct Standing {
    double drift;                 // m/s
    double excursion;             // m
    double fastest;               // m/s
    double turning = kUndefined;  // rad/s
};

MetricTable<Standing> parkedTable() {
    return {
        {{"drift", "Drift", "mm/min", "speed of the line fitted to the horizontal position after the first second",
          Say{1, "creeps by {} mm in a minute", 3}},
         [](const Standing& s) { return kMillimetres * kMinute * s.drift; }},
        {{"largest_excursion", "Excursion, maximum", "mm",
          "largest horizontal distance from the position after the first second", Say{2, "moves by at most {} mm", 3}},
         [](const Standing& s) { return kMillimetres * s.excursion; }},
        {{"largest_speed", "Speed, maximum", "m/s", "largest horizontal speed after the first second"},
         [](const Standing& s) { return s.fastest; }},
        {{"rotation", "Rotation", "deg/min", "slope of the line fitted to the heading after the first second",
          Say{3, "turns by {} deg in a minute", 4}},
         [](const Standing& s) { return kDegrees * kMinute * s.turning; }},
    };
}

Standing findStanding(const Log& log) {
    const auto needed = channels(log, {"chassis.x", "chassis.y", "chassis.vx"});
    const double from = needed[0].begin() + kSettling, to = needed[0].end();
    if (to - from < kShortestStanding) {
        notFound(fmt::format("the log lasts {:.2g} s, expected at least {:.2g} s", kSettling + to - from,
                             kSettling + kShortestStanding));
    }
    const TimeSeries v = part(speed(log), from, to), x = part(needed[0], from, to), y = part(needed[1], from, to);
    const double fastest = largestSample(v);
    if (fastest > kFastestParked) {
        notFound(
            fmt::format("the car moves at up to {:.2g} m/s, expected at most {:.2g} m/s", fastest, kFastestParked));
    }
    Standing found{.drift = std::hypot(fitLine(x.time, x.value).slope, fitLine(y.time, y.value).slope),
                   .excursion = 0,
                   .fastest = fastest};
    for (std::size_t i = 0; i < x.size(); ++i) {
        found.excursion =
            std::max(found.excursion, std::hypot(x.value[i] - x.value.front(), y.value[i] - y.value.front()));
    }
    if (const auto yaw = channelIfThere(log, "chassis.yaw")) {
        const TimeSeries heading = part(*yaw, from, to);
        found.turning = fitLine(heading.time, heading.value).slope;
    }
    return found;
}

}  // namespace

Manoeuvre parked() {
    return {"parked", "the car stands: drift of position and heading", [] { return definitions(parkedTable()); },
            [](const Log& log, const KnownCar&) { return values(parkedTable(), findStanding(log)); }};
}

}  // namespace tread
