// A car dropped onto its wheels: bounce frequency and damping of the body.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kLeastDrop = 0.01;        // m
constexpr double kFastestDrop = 0.5;       // m/s, horizontally
constexpr double kSettledShare = 0.02;     // of the drop: within, the body has settled
constexpr double kLeastSwing = 0.01;       // of the drop, peak to peak: smaller swings are left out
constexpr double kSwingNoise = 10;         // or smaller than this many standard deviations of the noise
constexpr double kHeightHalfWidth = 0.05;  // s

struct Bounce {
    double damped_frequency = kUndefined;  // Hz
    double damping_ratio = kUndefined;
};

struct Drop {
    double height;         // m
    double settling_time;  // s
    double dip;            // m below rest
    Bounce bounce;
};

MetricTable<Drop> dropAndSettleTable() {
    return {
        {{"drop", "Height of the drop", "mm", "height of the body at the beginning over that at rest"},
         [](const Drop& d) { return kMillimetres * d.height; }},
        {{"settling_time", "Settling time", "s",
          fmt::format("from the beginning until the body stays within {:.0f} % of the drop; undefined when it does not",
                      100 * kSettledShare),
          Say{1, "settles within {} s", 2}},
         [](const Drop& d) { return d.settling_time; }},
        {{"overshoot", "Overshoot", "-", "how far below rest the body dips, over the drop",
          Say{4, "dips by {} % of the drop", 0, 100}},
         [](const Drop& d) { return std::max(0.0, d.dip / d.height); }},
        {{"damped_frequency", "Bounce frequency, damped", "Hz",
          "from the times at which the body passes its height at rest; undefined when it does not swing"},
         [](const Drop& d) { return d.bounce.damped_frequency; }},
        {{"bounce_frequency", "Bounce frequency, undamped", "Hz", "damped frequency over sqrt(1 - damping ratio^2)",
          Say{2, "bounces at {} Hz", 2}},
         [](const Drop& d) {
             return d.bounce.damped_frequency / std::sqrt(1 - d.bounce.damping_ratio * d.bounce.damping_ratio);
         }},
        {{"damping_ratio", "Damping ratio", "-",
          "from the logarithmic decrement of the swings; undefined with fewer than two", Say{3, "damping ratio {}", 2}},
         [](const Drop& d) { return d.bounce.damping_ratio; }},
    };
}

// Times at which the body passes its height at rest, between one turning point and the next.
std::vector<double> passages(const TimeSeries& z, double rest, const std::vector<Instant>& turns) {
    std::vector<double> times;
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
        if (const auto t = firstCrossing(z, rest, turns[i].time, turns[i + 1].time)) times.push_back(*t);
    }
    return times;
}

Bounce findBounce(const TimeSeries& z, double rest, const std::vector<Instant>& turns) {
    Bounce bounce;
    if (turns.size() < 3) return bounce;
    const auto times = passages(z, rest, turns);
    if (times.size() > 1) {
        bounce.damped_frequency = 0.5 * static_cast<double>(times.size() - 1) / (times.back() - times.front());
    }
    // Decrement per half period from the swings, peak to peak: there an error of the height at rest does not matter.
    std::vector<double> number, logarithm;
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
        number.push_back(static_cast<double>(i));
        logarithm.push_back(std::log(std::abs(turns[i + 1].value - turns[i].value)));
    }
    const double decrement = -fitLine(number, logarithm).slope;
    bounce.damping_ratio = decrement / std::hypot(decrement, std::numbers::pi);
    return bounce;
}

double settlingTime(const TimeSeries& z, double rest, double band) {
    for (std::size_t i = z.size(); i-- > 0;) {
        if (std::abs(z.value[i] - rest) <= band) continue;
        if (i + 1 == z.size()) return kUndefined;
        const double level = z.value[i] > rest ? rest + band : rest - band;
        return firstCrossing(z, level, z.time[i]).value_or(z.time[i + 1]) - z.begin();
    }
    return 0;
}

Drop findDrop(const Log& log) {
    const TimeSeries measured = channels(log, {"chassis.z", "chassis.vx"}).front();
    const TimeSeries z = cleaned(measured, kHeightHalfWidth);
    const TimeSeries v = speed(log);
    const double fastest =
        *std::max_element(v.value.begin(), v.value.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    if (std::abs(fastest) > kFastestDrop) {
        notFound(fmt::format("the car moves at {:.2g} m/s, expected at most {:.2g} m/s", fastest, kFastestDrop));
    }
    const double rest = mean(z, z.end() - 0.1 * (z.end() - z.begin()), z.end());
    const double drop = z.value.front() - rest;
    if (drop < kLeastDrop) {
        notFound(fmt::format("the body sinks by {:.1f} mm, expected at least {:.1f} mm", kMillimetres * drop,
                             kMillimetres * kLeastDrop));
    }
    const auto turns = turningPoints(z, std::max(kLeastSwing * drop, kSwingNoise * noise(measured)));
    return {.height = drop,
            .settling_time = settlingTime(z, rest, kSettledShare * drop),
            .dip = rest - lowest(z, z.begin(), z.end()).value,
            .bounce = findBounce(z, rest, turns)};
}

}  // namespace

Manoeuvre dropAndSettle() {
    return {"drop_and_settle", "the car falls onto its wheels: settling time, bounce frequency, damping",
            [] { return definitions(dropAndSettleTable()); },
            [](const Log& log, const KnownCar&) { return values(dropAndSettleTable(), findDrop(log)); }};
}

}  // namespace tread
