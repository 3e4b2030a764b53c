// Starting on a hill: how far the car rolls back before it drives off.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kPedalHeld = 0.05;      // of a pedal: less is released
constexpr double kStill = 0.1;           // m/s: a car that is held is slower
constexpr double kDriving = 2.0;         // m/s
constexpr double kHillHalfWidth = 0.05;  // s
constexpr double kLeastGrade = 0.02;     // rise over run

struct HillStart {
    double release;       // s, of the brake
    double roll_back;     // m
    double fastest_back;  // m/s
    double drives_off;    // s after the release; NaN when it does not
    double held_drift;    // m, while the brake held the car
};

MetricTable<HillStart> hillStartTable() {
    return {
        {{"roll_back", "Roll-back", "m", "largest distance rolled backwards after the brake is released",
          Say{1, "rolls back by {} m", 2}},
         [](const HillStart& h) { return h.roll_back; }},
        {{"roll_back_speed", "Roll-back speed", "m/s", "largest speed backwards"},
         [](const HillStart& h) { return h.fastest_back; }},
        {{"drive_off_time", "Drive-off time", "s",
          fmt::format("from the release of the brake to {:.0f} m/s forwards; undefined when that is not reached",
                      kDriving),
          Say{2, "drives off within {} s", 1}},
         [](const HillStart& h) { return h.drives_off; }},
        {{"held_drift", "Drift on the brake", "mm", "distance that the car moves while the brake holds it"},
         [](const HillStart& h) { return 1000 * h.held_drift; }},
    };
}

HillStart findHillStart(const Log& log) {
    const auto needed = channels(log, {"driver.brake", "driver.throttle", "chassis.vx"});
    const TimeSeries& brake = needed[0];
    const TimeSeries v = cleaned(needed[2], kHillHalfWidth);
    const auto release = firstCrossing(brake, kPedalHeld, brake.begin());
    if (brake.value.front() <= kPedalHeld || !release) notFound("the brake is not held first and then released");
    const TimeSeries before = part(v, v.begin(), *release);
    for (double speed : before.value) {
        if (std::abs(speed) > kStill) notFound("the car moves while the brake is on");
    }
    if (const auto pitch = channelIfThere(log, "chassis.pitch")) {
        // Nose up is negative.
        const double grade = -mean(*pitch, v.begin(), *release);
        if (std::abs(grade) < kLeastGrade) notFound("the car does not stand on a hill");
    }
    if (highest(needed[1], *release, v.end()).value < kPedalHeld) notFound("the throttle is not used");
    HillStart found{};
    found.release = *release;
    double way = 0;
    for (std::size_t i = 1; i < v.size(); ++i) {
        if (v.time[i] <= *release) continue;
        way += 0.5 * (v.value[i] + v.value[i - 1]) * (v.time[i] - v.time[i - 1]);
        found.roll_back = std::max(found.roll_back, -way);
        found.fastest_back = std::max(found.fastest_back, -v.value[i]);
    }
    const auto off = firstCrossing(v, kDriving, *release);
    found.drives_off = off ? *off - *release : kUndefined;
    found.held_drift = std::abs(integral(v, v.begin(), *release));
    return found;
}

}  // namespace

Manoeuvre hillStart() {
    return {"hill_start", "starting on a hill: roll-back distance, time to drive off",
            [] { return definitions(hillStartTable()); },
            [](const Log& log, const KnownCar&) { return values(hillStartTable(), findHillStart(log)); }};
}

}  // namespace tread
