// Coast-down: driving resistance from the deceleration of a car that rolls free.

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/least_squares.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kSteering = 0.1;           // rad at the steering wheel
constexpr double kShortestCoasting = 3.0;   // s
constexpr double kLeastLoss = 0.1;          // of the speed
constexpr double kSlowestCoasting = 1.0;    // m/s: below, the resistance law does not hold
constexpr double kAirDensity = 1.225;       // kg/m3, standard atmosphere at sea level
constexpr double kBand = 20 * kKmh;         // m/s
constexpr double kCoastingHalfWidth = 0.5;  // s; coasting is slow

struct FreeRolling {
    double from = 0;
    double to = 0;
    double length() const { return to - from; }
};

// Longest time with both pedals released and the steering straight.
FreeRolling findCoasting(const TimeSeries& throttle, const TimeSeries& brake, const TimeSeries& v,
                         const std::optional<TimeSeries>& steering) {
    FreeRolling longest, current;
    bool coasting = false;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const bool free = throttle.value[i] < kRestingFoot && brake.value[i] < kRestingFoot &&
                          v.value[i] > kSlowestCoasting && (!steering || std::abs(steering->value[i]) < kSteering);
        if (free && !coasting) current.from = v.time[i];
        coasting = free;
        current.to = v.time[i];
        if (coasting && current.length() > longest.length()) longest = current;
    }
    return longest;
}

struct Resistance {
    double a0;   // m/s2
    double a2;   // 1/m
    double rms;  // m/s, speed left unexplained
};

// v(t) = c - a0 t - a2 * integral of v^2: needs no derivative of a noisy speed.
Resistance fitResistance(const TimeSeries& v) {
    const auto n = static_cast<Eigen::Index>(v.size());
    Eigen::MatrixXd terms(n, 3);
    Eigen::VectorXd target(n);
    double squares = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (i > 0) {
            // Exact for a speed that is linear between its samples.
            const double a = v.value[k - 1], b = v.value[k];
            squares += (a * a + a * b + b * b) / 3 * (v.time[k] - v.time[k - 1]);
        }
        terms.row(i) << 1, -(v.time[k] - v.begin()), -squares;
        target[i] = v.value[k];
    }
    const Eigen::VectorXd found = leastSquares(terms, target);
    const double rms = (terms * found - target).norm() / std::sqrt(static_cast<double>(n));
    return {found[1], found[2], rms};
}

struct Coasting {
    TimeSeries v, clean;  // m/s; as logged, and without noise
    Resistance resistance;
};

MetricTable<Coasting> coastDownTable() {
    return {
        {{"initial_speed", "Initial speed", "m/s", "speed at the beginning of coasting"},
         [](const Coasting& c) { return c.clean.value.front(); }},
        {{"final_speed", "Final speed", "m/s", "speed at its end"},
         [](const Coasting& c) { return c.clean.value.back(); }},
        {{"time", "Coasting time", "s", "time between the two", Say{1, "coasts for {} s", 1}},
         [](const Coasting& c) { return c.v.end() - c.v.begin(); }},
        {{"distance", "Coasting distance", "m", "distance between the two", Say{2, "rolls {} m", 0}},
         [](const Coasting& c) { return integral(c.v, c.v.begin(), c.v.end()); }},
        {{"deceleration_constant", "Deceleration law, constant part a0", "m/s2",
          "a0 of the fitted deceleration a0 + a2 v^2"},
         [](const Coasting& c) { return c.resistance.a0; }},
        {{"deceleration_square", "Deceleration law, square part a2", "1/m",
          "a2 of the fitted deceleration a0 + a2 v^2"},
         [](const Coasting& c) { return c.resistance.a2; }},
        {{"rolling_resistance", "Rolling resistance coefficient", "-",
          "a0 / g: rolling resistance coefficient, including the drag of the driveline",
          Say{3, "rolling resistance coefficient {}", 4}},
         [](const Coasting& c) { return c.resistance.a0 / kGravity; }},
        {{"drag_area_over_mass", "Drag area over mass", "m2/kg",
          fmt::format("2 a2 / air density of {:.3f} kg/m3; mass including rotating parts", kAirDensity)},
         [](const Coasting& c) { return 2 * c.resistance.a2 / kAirDensity; }},
        {{"fit_rms", "Misfit of the deceleration law", "m/s", "rms deviation of the speed from the fitted law"},
         [](const Coasting& c) { return c.resistance.rms; }},
    };
}

struct SpeedBand {
    double time;      // s
    double distance;  // m
};

// The metrics of a band of speeds; the ends in km/h.
MetricTable<SpeedBand> bandTable(const std::string& high, const std::string& low) {
    const std::string band = fmt::format("{}_to_{}_kmh", high, low);
    const std::string words = fmt::format("while the speed falls from {} to {} km/h", high, low);
    return {{{"time_" + band, fmt::format("Time from {} to {} km/h", high, low), "s", "time " + words},
             [](const SpeedBand& b) { return b.time; }},
            {{"distance_" + band, fmt::format("Distance from {} to {} km/h", high, low), "m", "distance " + words},
             [](const SpeedBand& b) { return b.distance; }}};
}

std::vector<Metric> bands(const TimeSeries& v) {
    std::vector<Metric> out;
    const double fastest = *std::max_element(v.value.begin(), v.value.end());
    const auto text = [](double speed) { return fmt::format("{:.0f}", speed / kKmh); };
    for (double high = std::floor(fastest / kBand) * kBand; high > kBand / 2; high -= kBand) {
        const double low = high - kBand;
        const auto from = firstCrossing(v, high, v.begin()), to = firstCrossing(v, low, v.begin());
        if (!from || !to) continue;
        const auto band = values(bandTable(text(high), text(low)), SpeedBand{*to - *from, integral(v, *from, *to)});
        out.insert(out.end(), band.begin(), band.end());
    }
    return out;
}

Coasting findCoastDown(const Log& log) {
    const auto needed = channels(log, {"driver.throttle", "driver.brake", "chassis.vx"});
    const auto steering = channelIfThere(log, "driver.steering_wheel_angle");
    const FreeRolling found = findCoasting(needed[0], needed[1], needed[2], steering);
    if (found.length() < kShortestCoasting) {
        notFound(
            fmt::format("the car rolls with both pedals released and straight steering for only {:.2g} s, "
                        "expected at least {:.2g} s",
                        found.length(), kShortestCoasting));
    }
    const TimeSeries v = part(needed[2], found.from, found.to);
    const TimeSeries clean = cleaned(v, kCoastingHalfWidth);
    const double first = clean.value.front(), last = clean.value.back();
    if (last > (1 - kLeastLoss) * first) {
        notFound(
            fmt::format("the speed goes from {:.3g} to {:.3g} m/s while the car rolls free, expected a "
                        "loss of at least {:.0f} %",
                        first, last, 100 * kLeastLoss));
    }
    return {v, clean, fitResistance(v)};
}

template <class T>
std::vector<T> joined(std::vector<T> first, const std::vector<T>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

}  // namespace

Manoeuvre coastDown() {
    return {"coast_down", "rolling free: rolling resistance and drag area",
            [] {
                const std::string lower = fmt::format("<v-{:.0f}>", kBand / kKmh);
                return joined(definitions(coastDownTable()), definitions(bandTable("<v>", lower)));
            },
            [](const Log& log, const KnownCar&) {
                const Coasting found = findCoastDown(log);
                return joined(values(coastDownTable(), found), bands(found.clean));
            }};
}

}  // namespace tread
