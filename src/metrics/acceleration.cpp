// Acceleration with full throttle in a straight line.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kFullThrottle = 0.9;      // of the pedal
constexpr double kLeastGain = 5;           // m/s
constexpr double kRollsFrom = 1.0;         // m/s: a car that is faster when it starts does not start from rest
constexpr double kStandingDistance = 400;  // m

struct Acceleration {
    double onset;    // s, of the throttle
    double initial;  // m/s
    double most;     // m/s
    double peak;     // m/s2
    TimeSeries v;
    TimeSeries way;  // m, since the onset

    // Since the onset, s; NaN when the speed is not reached or the car was already faster.
    double timeTo(double kmh) const {
        if (initial > kmh * kKmh) return kUndefined;
        const auto t = firstCrossing(v, kmh * kKmh, onset);
        return t ? *t - onset : kUndefined;
    }
    double distanceTo(double kmh) const {
        const double t = timeTo(kmh);
        return std::isnan(t) ? kUndefined : at(way, onset + t);
    }
};

double fromRest(const Acceleration& a, double value) {
    return a.initial < kRollsFrom ? value : kUndefined;
}

MetricTable<Acceleration> accelerationTable() {
    return {
        {{"time_0_to_100_kmh", "Time from 0 to 100 km/h", "s",
          "from the throttle pedal to 100 km/h; undefined when the car is already rolling",
          Say{1, "100 km/h after {} s", 1}},
         [](const Acceleration& a) { return fromRest(a, a.timeTo(100)); }},
        {{"time_0_to_60_kmh", "Time from 0 to 60 km/h", "s", "from the throttle pedal to 60 km/h"},
         [](const Acceleration& a) { return fromRest(a, a.timeTo(60)); }},
        {{"time_80_to_120_kmh", "Time from 80 to 120 km/h", "s", "between the two speeds",
          Say{2, "80 to 120 km/h within {} s", 1}},
         [](const Acceleration& a) { return a.timeTo(120) - a.timeTo(80); }},
        {{"distance_0_to_100_kmh", "Distance from 0 to 100 km/h", "m", "from the throttle pedal to 100 km/h"},
         [](const Acceleration& a) { return fromRest(a, a.distanceTo(100)); }},
        {{"time_400_m", "Time over 400 m", "s", "from rest over 400 m", Say{3, "400 m within {} s", 1}},
         [](const Acceleration& a) {
             const auto t = firstCrossing(a.way, kStandingDistance, a.onset);
             return fromRest(a, t ? *t - a.onset : kUndefined);
         }},
        {{"peak_acceleration", "Acceleration, peak", "m/s2", "largest slope of the speed"},
         [](const Acceleration& a) { return a.peak; }},
        {{"initial_speed", "Initial speed", "m/s", "speed when the throttle pedal is pressed"},
         [](const Acceleration& a) { return a.initial; }},
        {{"largest_speed", "Speed, maximum", "m/s", "to the end of the log or to the brake"},
         [](const Acceleration& a) { return a.most; }},
    };
}

Acceleration findAcceleration(const Log& log) {
    const auto needed = channels(log, {"driver.throttle", "chassis.vx"});
    const TimeSeries& throttle = needed[0];
    const auto full = throttle.value.front() >= kFullThrottle
                          ? throttle.begin()
                          : firstCrossing(throttle, kFullThrottle, throttle.begin());
    if (!full) notFound("the throttle is never opened fully");
    double end = throttle.end();
    if (const auto brake = channelIfThere(log, "driver.brake")) {
        end = firstCrossing(*brake, kRestingFoot, *full).value_or(end);
    }
    end = std::min(end, firstCrossing(throttle, kFullThrottle, std::min(*full + 0.2, end)).value_or(end));
    Acceleration a{};
    const double idle = throttle.value.front() < kFullThrottle ? mean(throttle, throttle.begin(), *full - 0.5) : 0;
    a.onset = lastCrossing(throttle, idle + 0.02, throttle.begin(), *full).value_or(*full);
    a.v = part(cleaned(needed[1], kSpeedHalfWidth), a.onset, end);
    a.initial = a.v.value.front();
    a.most = highest(a.v, a.onset, end).value;
    if (a.most - a.initial < kLeastGain) {
        notFound(fmt::format("with full throttle the car gains only {:.2g} m/s, expected at least {:.2g} m/s",
                             a.most - a.initial, kLeastGain));
    }
    a.peak = highest(derivative(a.v, kSpeedHalfWidth), a.onset, end).value;
    a.way = a.v;
    a.way.value.front() = 0;
    for (std::size_t i = 1; i < a.v.size(); ++i) {
        a.way.value[i] = a.way.value[i - 1] + 0.5 * (a.v.value[i] + a.v.value[i - 1]) * (a.v.time[i] - a.v.time[i - 1]);
    }
    return a;
}

}  // namespace

Manoeuvre acceleration() {
    return {"acceleration", "full throttle: times and distances to speeds",
            [] { return definitions(accelerationTable()); },
            [](const Log& log, const KnownCar&) { return values(accelerationTable(), findAcceleration(log)); }};
}

}  // namespace tread
