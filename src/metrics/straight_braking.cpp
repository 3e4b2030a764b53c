// Braking in a straight line: stopping distance and mean fully developed deceleration, after UN R13-H and ISO 21994.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"
#include "metrics/stop.h"

namespace tread {
namespace {

constexpr double kLargestSteering = 0.35;       // rad at the steering wheel: more is no straight line
constexpr double kLockedSlip = -0.9;            // slip ratio below which a wheel counts as locked
constexpr double kLockedUntil = 1.0;            // m/s: below, every braked wheel stands still sooner or later
constexpr double kBrakingPeakHalfWidth = 0.05;  // s
constexpr double kNominalSteps = 10 * kKmh;     // nominal speeds are whole tens of km/h

constexpr std::array kWheels = {"front_left", "front_right", "rear_left", "rear_right"};

struct Braking {
    Stop stop;
    double mfdd;                                       // m/s2
    double peak;                                       // m/s2
    double deviation;                                  // m
    std::array<double, kWheels.size()> locked_shares;  // of the time
};

// The nominal speed is a whole ten of km/h.
double correctedDistance(const Stop& stop) {
    const double nominal = std::max(1.0, std::round(stop.initial_speed / kNominalSteps)) * kNominalSteps;
    return stop.distance * std::pow(nominal / stop.initial_speed, 2);
}

MetricTable<Braking> straightBrakingTable() {
    MetricTable<Braking> lines = {
        {{"initial_speed", "Initial speed", "m/s", "speed when the driver starts to actuate the brake"},
         [](const Braking& b) { return b.stop.initial_speed; }},
        {{"stopping_distance", "Stopping distance", "m", "distance from the start of brake actuation to standstill",
          Say{1, "stops within {} m", 1}},
         [](const Braking& b) { return b.stop.distance; }},
        {{"corrected_stopping_distance", "Stopping distance, corrected to nominal speed", "m",
          fmt::format("stopping distance times (nominal / initial speed)^2, nominal: the nearest whole {:.0f} km/h",
                      kNominalSteps / kKmh)},
         [](const Braking& b) { return correctedDistance(b.stop); }},
        {{"stopping_time", "Stopping time", "s", "from the start of brake actuation to standstill"},
         [](const Braking& b) { return b.stop.duration(); }},
        {{"mfdd", "Deceleration, mean fully developed", "m/s2",
          "mean fully developed deceleration: (vb^2 - ve^2) / (2 (se - sb)), vb = 0.8 v0, ve = 0.1 v0",
          Say{2, "mean fully developed deceleration {} m/s2", 2}},
         [](const Braking& b) { return b.mfdd; }},
        {{"mean_deceleration", "Deceleration, mean", "m/s2", "initial speed over stopping time"},
         [](const Braking& b) { return b.stop.initial_speed / b.stop.duration(); }},
        {{"peak_deceleration", "Deceleration, peak", "m/s2",
          "largest deceleration from brake actuation down to 10 % of the initial speed, where the mean fully developed "
          "deceleration ends; without the jerk when the car comes to rest"},
         [](const Braking& b) { return b.peak; }},
        {{"lateral_deviation", "Lateral deviation", "m",
          "largest distance from the line along which the car pointed at brake actuation; left is positive",
          Say{4, "{} m off its line", 2}},
         [](const Braking& b) { return b.deviation; }},
    };
    for (std::size_t wheel = 0; wheel < kWheels.size(); ++wheel) {
        lines.push_back({{fmt::format("locked_share_{}", kWheels[wheel]),
                          titleOf("time with locked wheel", inWords(kWheels[wheel])), "-",
                          fmt::format("share of the time, down to {:.0f} m/s, with a slip ratio below {:.1f}",
                                      kLockedUntil, kLockedSlip),
                          wheel == 0 ? Say{3, "front left wheel locked for {} % of the time", 0, 100} : Say{}},
                         [wheel](const Braking& b) { return b.locked_shares[wheel]; }});
    }
    return lines;
}

void checkStraight(const Log& log, const Stop& stop) {
    expectNoTurn(log, stop);
    const auto steering = channelIfThere(log, "driver.steering_wheel_angle");
    if (!steering) return;
    const TimeSeries during = part(*steering, stop.start, stop.end);
    for (double angle : during.value) {
        if (std::abs(angle - during.value.front()) <= kLargestSteering) continue;
        notFound(
            fmt::format("the steering wheel turns by more than {:.0f} deg while braking", kDegrees * kLargestSteering));
    }
}

double peakDeceleration(const Log& log, const TimeSeries& v, const Stop& stop) {
    const auto logged = channelIfThere(log, "chassis.ax");
    const TimeSeries acceleration = logged ? *logged : cleanDerivative(v, kSpeedHalfWidth);
    // Averaged and not smoothed: a parabola would overshoot where the car comes to rest with a jerk.
    const bool noisy = logged && isNoisy(*logged);
    const TimeSeries during =
        part(noisy ? averaged(*logged, kBrakingPeakHalfWidth) : acceleration, stop.start, developedEnd(v, stop));
    return -*std::min_element(during.value.begin(), during.value.end());
}

// Slip ratio of a wheel; from its spin, with the rolling radius it had when the brake was applied, if not logged.
std::optional<TimeSeries> slipOf(const Log& log, const TimeSeries& v, const Stop& stop, const std::string& wheel) {
    if (auto slip = channelIfThere(log, wheel + ".slip_ratio")) return slip;
    auto spin = channelIfThere(log, wheel + ".spin");
    if (!spin || at(*spin, stop.start) <= 0) return {};
    const double radius = stop.initial_speed / at(*spin, stop.start);
    for (std::size_t i = 0; i < spin->size(); ++i) {
        spin->value[i] = spin->value[i] * radius / std::max(v.value[i], kNearlyStopped) - 1;
    }
    return spin;
}

double lockedShare(const Log& log, const TimeSeries& v, const Stop& stop, const std::string& wheel) {
    const double until = firstCrossing(v, kLockedUntil, stop.start).value_or(stop.end);
    const auto slip = slipOf(log, v, stop, wheel);
    if (!slip) return kUndefined;
    TimeSeries locked = part(*slip, stop.start, until);
    for (double& value : locked.value) value = value < kLockedSlip ? 1 : 0;
    return mean(locked, stop.start, until);
}

Braking findBraking(const Log& log) {
    const TimeSeries v = cleaned(speed(log), kSpeedHalfWidth);
    const Stop stop = findStop(log);
    checkStraight(log, stop);
    Braking found{.stop = stop,
                  .mfdd = meanFullyDeveloped(v, stop),
                  .peak = peakDeceleration(log, v, stop),
                  .deviation = lateralDeviation(log, stop),
                  .locked_shares = {}};
    for (std::size_t wheel = 0; wheel < kWheels.size(); ++wheel) {
        found.locked_shares[wheel] = lockedShare(log, v, stop, std::string("wheel.") + kWheels[wheel]);
    }
    return found;
}

}  // namespace

Manoeuvre straightBraking() {
    return {"straight_braking", "braking to standstill: stopping distance, MFDD, locked wheels",
            [] { return definitions(straightBrakingTable()); },
            [](const Log& log, const KnownCar&) { return values(straightBrakingTable(), findBraking(log)); }};
}

}  // namespace tread
