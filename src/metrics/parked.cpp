#include "metrics/parked.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"

namespace tread {
namespace {

constexpr std::string_view kName = "parked";
constexpr double kSettling = 1.0;  // s at the beginning, in which the car may sink into its springs
constexpr double kShortest = 1.0;  // s of standing after that
constexpr double kFastest = 0.3;   // m/s: more is no parked car
constexpr double kMinute = 60;     // s
constexpr double kMillimetres = 1000;

double largestMagnitude(const TimeSeries& series) {
    double largest = 0;
    for (double value : series.value) largest = std::max(largest, std::abs(value));
    return largest;
}

}  // namespace

std::vector<Metric> parkedMetrics(const Log& log, const KnownCar&) {
    const auto needed = channels(log, kName, {"chassis.x", "chassis.y", "chassis.vx"});
    const double from = needed[0].begin() + kSettling, to = needed[0].end();
    if (to - from < kShortest) {
        notFound(kName, fmt::format("the log lasts {:.2g} s, looked for at least {:.2g} s", kSettling + to - from,
                                    kSettling + kShortest));
    }
    const TimeSeries v = part(speed(log, kName), from, to), x = part(needed[0], from, to), y = part(needed[1], from, to);
    const double fastest = largestMagnitude(v);
    if (fastest > kFastest) {
        notFound(kName,
                 fmt::format("the car moves at up to {:.2g} m/s, looked for at most {:.2g} m/s", fastest, kFastest));
    }
    double excursion = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        excursion = std::max(excursion, std::hypot(x.value[i] - x.value.front(), y.value[i] - y.value.front()));
    }
    const double drift = std::hypot(fitLine(x.time, x.value).slope, fitLine(y.time, y.value).slope);
    const auto yaw = channelIfThere(log, kName, "chassis.yaw");
    const TimeSeries heading = yaw ? part(*yaw, from, to) : TimeSeries{};

    std::vector<Metric> out;
    out.push_back({"drift", kMillimetres * kMinute * drift, "mm/min",
                   "speed of the line fitted to the horizontal position after the first second"});
    out.push_back({"largest_excursion", kMillimetres * excursion, "mm",
                   "largest horizontal distance from the position after the first second"});
    out.push_back({"largest_speed", fastest, "m/s", "largest horizontal speed after the first second"});
    out.push_back({"rotation", yaw ? kDegrees * kMinute * fitLine(heading.time, heading.value).slope : kUndefined,
                   "deg/min", "slope of the line fitted to the heading after the first second"});
    return out;
}

}  // namespace tread
