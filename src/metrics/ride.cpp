// Ride on an uneven road: what the people feel, and how evenly the tyres press on the road.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/ride.h"
#include "metrics/vibration_weighting.h"

namespace tread {
namespace {

constexpr double kShortestRide = 4;  // s of riding after that
constexpr double kSlowestRide = 3;   // m/s
constexpr double kMostSteering = 5;  // deg of the steering wheel: more is driving, not riding
constexpr double kSmooth = 0.02;     // m/s2, weighted: nobody feels less (ISO 2631-1, annex C: threshold 0.015)
constexpr double kPercent = 100;

struct Ride {
    double speed;  // m/s
    double vertical;
    double longitudinal = kUndefined, lateral = kUndefined;  // m/s2, weighted
    std::array<double, 4> load_variation{kUndefined, kUndefined, kUndefined, kUndefined};
    double lowest_load = kUndefined;  // of the mean
    double travel = kUndefined;       // m
};

MetricTable<Ride> rideTable() {
    MetricTable<Ride> lines{
        {{"speed", "Speed, mean", "km/h", "mean speed after the first two seconds, which all metrics leave out"},
         [](const Ride& r) { return r.speed / kKmh; }},
        {{"vertical_weighted", "Vertical acceleration, weighted (Wk)", "m/s2",
          "root mean square of the vertical acceleration at the centre of gravity, weighted by Wk of ISO 2631-1",
          Say{1, "weighted vertical acceleration {} m/s2", 2}},
         [](const Ride& r) { return r.vertical; }},
        {{"longitudinal_weighted", "Longitudinal acceleration, weighted (Wd)", "m/s2",
          "the same for the longitudinal acceleration, weighted by Wd"},
         [](const Ride& r) { return r.longitudinal; }},
        {{"lateral_weighted", "Lateral acceleration, weighted (Wd)", "m/s2",
          "the same for the lateral acceleration, weighted by Wd"},
         [](const Ride& r) { return r.lateral; }},
        {{"total_weighted", "Vibration total value", "m/s2",
          "vibration total value: root of the sum of the squares of all three (k = 1)"},
         [](const Ride& r) { return std::hypot(r.longitudinal, r.lateral, r.vertical); }},
    };
    for (std::size_t i = 0; i < kWheelNames.size(); ++i) {
        lines.push_back({{fmt::format("load_variation_{}", kWheelNames[i]),
                          titleOf("wheel load, variation", inWords(kWheelNames[i])), "%",
                          "dynamic load coefficient: standard deviation of the wheel load over its mean"},
                         [i](const Ride& r) { return kPercent * r.load_variation[i]; }});
    }
    lines.push_back({{"lowest_load", "Wheel load over its mean, minimum", "%",
                      "smallest load of any wheel over its mean; 0: the wheel lifts off",
                      Say{2, "lightest wheel carries {} % of its load", 0}},
                     [](const Ride& r) { return kPercent * r.lowest_load; }});
    lines.push_back(
        {{"travel", "Suspension travel, standard deviation", "mm",
          "largest standard deviation of the suspension travel of any wheel", Say{3, "suspension travels by {} mm", 1}},
         [](const Ride& r) { return kMillimetres * r.travel; }});
    return lines;
}

double deviation(const TimeSeries& series) {
    const double level = mean(series, series.begin(), series.end());
    const TimeSeries squares = [&] {
        TimeSeries out = series;
        for (double& value : out.value) value = (value - level) * (value - level);
        return out;
    }();
    return std::sqrt(mean(squares, series.begin(), series.end()));
}

void findWheels(Ride& ride, const Log& log, double from, double to) {
    for (std::size_t i = 0; i < kWheelNames.size(); ++i) {
        if (const auto whole = channelIfThere(log, fmt::format("wheel.{}.load", kWheelNames[i]))) {
            const TimeSeries load = part(*whole, from, to);
            const double level = mean(load, from, to);
            ride.load_variation[i] = deviation(load) / level;
            const double lowest = *std::min_element(load.value.begin(), load.value.end()) / level;
            ride.lowest_load = std::fmin(ride.lowest_load, lowest);
        }
        if (const auto travel = channelIfThere(log, fmt::format("wheel.{}.travel", kWheelNames[i])))
            ride.travel = std::fmax(ride.travel, deviation(part(*travel, from, to)));
    }
}

Ride findRide(const Log& log) {
    const auto needed = channels(log, {"chassis.vx", "chassis.az"});
    const double from = needed[0].begin() + kRideApproach, to = needed[0].end();
    if (to - from < kShortestRide) {
        notFound(fmt::format("the log lasts {:.2g} s, expected at least {:.2g} s", kRideApproach + to - from,
                             kRideApproach + kShortestRide));
    }
    Ride ride{.speed = mean(needed[0], from, to),
              .vertical = weightedRms(part(needed[1], from, to), VibrationWeighting::Wk)};
    if (ride.speed < kSlowestRide) {
        notFound(fmt::format("the car drives at {:.2g} m/s, expected at least {:.2g} m/s", ride.speed, kSlowestRide));
    }
    if (const auto hand = channelIfThere(log, "driver.steering_wheel_angle")) {
        const double turned = kDegrees * range(part(*hand, from, to)).width();
        if (turned > kMostSteering) {
            notFound(fmt::format("the steering wheel turns by {:.2g} deg, expected at most {:.2g} deg", turned,
                                 kMostSteering));
        }
    }
    if (ride.vertical < kSmooth) {
        notFound(fmt::format("the weighted vertical acceleration is {:.2g} m/s2, expected at least {:.2g} m/s2",
                             ride.vertical, kSmooth));
    }
    if (const auto ax = channelIfThere(log, "chassis.ax"))
        ride.longitudinal = weightedRms(part(*ax, from, to), VibrationWeighting::Wd);
    if (const auto ay = channelIfThere(log, "chassis.ay"))
        ride.lateral = weightedRms(part(*ay, from, to), VibrationWeighting::Wd);
    findWheels(ride, log, from, to);
    return ride;
}

}  // namespace

Manoeuvre ride() {
    return {"ride", "driving on an uneven road: weighted accelerations (ISO 2631-1), variation of the wheel loads",
            [] { return definitions(rideTable()); },
            [](const Log& log, const KnownCar&) { return values(rideTable(), findRide(log)); }};
}

}  // namespace tread
