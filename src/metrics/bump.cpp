// Drive over a bump: what reaches body and wheels.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kEvenRoad = 0.3;     // s of even road
constexpr double kEven = 0.03;        // share of its mean by which a wheel load may vary before
constexpr double kLeastBump = 0.25;   // share by which a bump changes it
constexpr double kOffTheRoad = 0.01;  // share of the static load below which a wheel is off the road
constexpr double kCalm = 0.5;         // m/s2 of vertical acceleration that counts as settled

struct Bump {
    double speed = 0;                                       // m/s
    double highest_az = 0, lowest_az = 0;                   // m/s2
    double pitch_rate = 0, roll_rate = 0;                   // rad/s, largest magnitudes
    double highest_load = 0, lowest_load = kUndefined;      // share of the load before, of any wheel
    double off_the_road = 0;                                // s, of the wheel with the longest
    double compression = kUndefined, rebound = kUndefined;  // m, of any wheel
    double settling = 0;                                    // s
};

MetricTable<Bump> bumpTable() {
    return {
        {{"speed", "Speed before the bump", "m/s", "before the bump"}, [](const Bump& b) { return b.speed; }},
        {{"highest_az", "Vertical acceleration, upward peak", "m/s2", "largest upward acceleration of the body",
          Say{1, "body thrown up at {} m/s2", 1}},
         [](const Bump& b) { return b.highest_az; }},
        {{"lowest_az", "Vertical acceleration, downward peak", "m/s2", "largest downward acceleration, negative"},
         [](const Bump& b) { return b.lowest_az; }},
        {{"peak_pitch_rate", "Pitch rate, peak", "deg/s", "largest magnitude"},
         [](const Bump& b) { return kDegrees * b.pitch_rate; }},
        {{"peak_roll_rate", "Roll rate, peak", "deg/s", "largest magnitude"},
         [](const Bump& b) { return kDegrees * b.roll_rate; }},
        {{"highest_load", "Wheel load over initial, maximum", "-", "largest load of a wheel over its initial load"},
         [](const Bump& b) { return b.highest_load; }},
        {{"lowest_load", "Wheel load over initial, minimum", "-", "smallest load of a wheel over its initial load",
          Say{2, "lightest wheel carries {} % of its load", 0, 100}},
         [](const Bump& b) { return b.lowest_load; }},
        {{"off_the_road", "Time off the road", "s",
          fmt::format("longest time for which a wheel carries less than {:.0f} % of that load", 100 * kOffTheRoad)},
         [](const Bump& b) { return b.off_the_road; }},
        {{"compression", "Suspension compression, maximum", "mm",
          "largest upward suspension travel of any wheel from its initial position"},
         [](const Bump& b) { return 1000 * b.compression; }},
        {{"rebound", "Suspension rebound, maximum", "mm", "largest travel downwards"},
         [](const Bump& b) { return 1000 * b.rebound; }},
        {{"settling_time", "Settling time", "s",
          fmt::format("from the first change of a wheel load to the last vertical acceleration above {:.2g} m/s2",
                      kCalm),
          Say{3, "settles after {} s", 1}},
         [](const Bump& b) { return b.settling; }},
    };
}

double timeBelow(const TimeSeries& series, double level) {
    double below = 0;
    for (std::size_t i = 1; i < series.size(); ++i) {
        if (series.value[i - 1] < level && series.value[i] < level) below += series.time[i] - series.time[i - 1];
    }
    return below;
}

// The time of the first change of a wheel load.
double findLoads(Bump& bump, const Log& log) {
    double first = std::numeric_limits<double>::infinity();
    for (std::string_view wheel : kWheelNames) {
        const std::string name = fmt::format("wheel.{}.load", wheel);
        const TimeSeries load = channels(log, {name}).front();
        const double begin = load.begin(), still = mean(load, begin, begin + kEvenRoad);
        // Samples: no parabola at the edges where a wheel leaves the road.
        const auto [low, high] = range(load);
        const auto [low_at_first, high_at_first] = range(part(load, begin, begin + kEvenRoad));
        if (still <= 0 || std::max(high_at_first - still, still - low_at_first) > kEven * still)
            notFound(fmt::format("{} is not steady for the first {:.2g} s", name, kEvenRoad));
        if (std::max(high - still, still - low) > kLeastBump * still) {
            for (double level : {1 - kEven, 1 + kEven})
                first = std::min(first, firstCrossing(load, level * still, begin).value_or(first));
        }
        bump.highest_load = std::max(bump.highest_load, high / still);
        bump.lowest_load = std::fmin(bump.lowest_load, low / still);
        bump.off_the_road = std::max(bump.off_the_road, timeBelow(load, kOffTheRoad * still));
    }
    if (std::isinf(first)) notFound(fmt::format("no wheel load changes by more than {:.0f} %", 100 * kLeastBump));
    return first;
}

void findTravel(Bump& bump, const Log& log) {
    for (std::string_view wheel : kWheelNames) {
        const auto travel = channelIfThere(log, fmt::format("wheel.{}.travel", wheel));
        if (!travel) continue;
        const double begin = travel->begin(), end = travel->end(), still = mean(*travel, begin, begin + kEvenRoad);
        bump.compression = std::fmax(bump.compression, highest(*travel, begin, end).value - still);
        bump.rebound = std::fmax(bump.rebound, still - lowest(*travel, begin, end).value);
    }
}

// Braking, steering and driving off shift the loads as well.
void refuseOtherCauses(const Log& log) {
    for (std::string_view name : {"chassis.ax", "chassis.ay"}) {
        const auto acceleration = channelIfThere(log, name);
        if (!acceleration) continue;
        const TimeSeries slow = averaged(*acceleration, 0.25);
        constexpr double kMost = 1.5;  // m/s2
        if (largestSample(slow) > kMost)
            notFound(
                fmt::format("{} reaches {:.2g} m/s2, expected at most {:.2g} m/s2", name, largestSample(slow), kMost));
    }
}

Bump findBump(const Log& log) {
    const auto needed = channels(log, {"chassis.vx", "chassis.az", "chassis.pitch_rate", "chassis.roll_rate"});
    const TimeSeries& az = needed[1];
    refuseOtherCauses(log);
    Bump bump;
    const double first = findLoads(bump, log);
    findTravel(bump, log);
    bump.speed = mean(needed[0], az.begin(), az.begin() + kEvenRoad);
    bump.highest_az = highest(az, first, az.end()).value;
    bump.lowest_az = lowest(az, first, az.end()).value;
    bump.pitch_rate = largestSample(needed[2]);
    bump.roll_rate = largestSample(needed[3]);
    double last = first;
    for (double level : {kCalm, -kCalm})
        last = std::max(last, lastCrossing(az, level, first, az.end()).value_or(first));
    bump.settling = std::abs(az.value.back()) > kCalm ? kUndefined : last - first;
    return bump;
}

}  // namespace

Manoeuvre bump() {
    return {"bump", "drive over a bump: vertical acceleration, wheel loads, suspension travel",
            [] { return definitions(bumpTable()); },
            [](const Log& log, const KnownCar&) { return values(bumpTable(), findBump(log)); }};
}

}  // namespace tread
