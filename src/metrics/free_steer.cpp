// Hands off the wheel in a steady turn: how the car straightens itself. After the idea of ISO 17288-1, whose text was
// not read; shares, times and the 10 % are a choice.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kOff = 0.5;                     // of the signal, above which the hands are off
constexpr double kLeastTime = 2;                 // s without hands
constexpr double kBeforeRelease = 0.3;           // s before the release, for what was steady
constexpr double kLeastFreeTurn = 1 / kDegrees;  // rad/s
constexpr double kSettled = 0.1;                 // of the yaw rate at release
constexpr double kFirst = 1;                     // s after release

struct FreeSteer {
    double speed, yaw_rate, ay, steering;  // at release
    double first;                          // share of the yaw rate left after kFirst
    double overshoot, settling;            // -, s
    double steering_overshoot;             // -
    double last_steering;                  // rad
};

MetricTable<FreeSteer> freeSteerTable() {
    return {
        {{"settling_time", "Settling time", "s",
          fmt::format("from the release until the yaw rate stays within {:.0f} % of that at release; undefined when it "
                      "does not",
                      100 * kSettled),
          Say{1, "straight within {} s of the release", 2}},
         [](const FreeSteer& f) { return f.settling; }},
        {{"yaw_rate_overshoot", "Yaw rate, overshoot", "-", "largest yaw rate to the other side over that at release",
          Say{2, "overshoots by {} %", 0, 100}},
         [](const FreeSteer& f) { return f.overshoot; }},
        {{"yaw_rate_left", "Yaw rate left after release", "-",
          fmt::format("yaw rate {:.0f} s after the release over that at release", kFirst)},
         [](const FreeSteer& f) { return f.first; }},
        {{"steering_overshoot", "Steering-wheel angle, overshoot", "-",
          "largest steering-wheel angle to the other side over that at release"},
         [](const FreeSteer& f) { return f.steering_overshoot; }},
        {{"last_steering_angle", "Steering-wheel angle at the end", "deg", "steering-wheel angle at the end of the log",
          Say{3, "steering wheel at {} deg at the end", 1}},
         [](const FreeSteer& f) { return kDegrees * f.last_steering; }},
        {{"speed", "Speed at release", "m/s", "at release"}, [](const FreeSteer& f) { return f.speed; }},
        {{"yaw_rate", "Yaw rate at release", "deg/s", "at release"},
         [](const FreeSteer& f) { return kDegrees * f.yaw_rate; }},
        {{"ay", "Lateral acceleration at release", "m/s2", "lateral acceleration at release"},
         [](const FreeSteer& f) { return f.ay; }},
        {{"steering_angle", "Steering-wheel angle at release", "deg", "at release"},
         [](const FreeSteer& f) { return kDegrees * f.steering; }},
    };
}

// The largest excursion to the other side of zero, over the value at release.
double overshootOf(const TimeSeries& series, double release, double before) {
    const double other =
        before > 0 ? lowest(series, release, series.end()).value : highest(series, release, series.end()).value;
    return std::max(0.0, -other / before);
}

// When the series enters the band for good; NaN when it never does.
double settlingOf(const TimeSeries& series, double release, double band) {
    const auto up = lastCrossing(series, band, release, series.end());
    const auto down = lastCrossing(series, -band, release, series.end());
    if (std::abs(series.value.back()) > band) return kUndefined;
    return std::max(up.value_or(release), down.value_or(release)) - release;
}

FreeSteer findFreeSteer(const Log& log) {
    const auto needed =
        channels(log, {"driver.hands_off", "driver.steering_wheel_angle", "chassis.yaw_rate", "chassis.ay"});
    const TimeSeries& off = needed[0];
    const auto release = firstCrossing(off, kOff, off.begin());
    if (!release || off.value.back() < kOff || lastCrossing(off, kOff, *release, off.end()).value_or(0) > *release)
        notFound("the steering wheel is not released for good");
    if (off.end() - *release < kLeastTime) {
        notFound(fmt::format("the log ends {:.2g} s after the release, expected at least {:.2g} s",
                             off.end() - *release, kLeastTime));
    }
    const TimeSeries yaw_rate = cleaned(needed[2], kResponseHalfWidth);
    const auto before = [&](const TimeSeries& series) { return mean(series, *release - kBeforeRelease, *release); };
    FreeSteer found{};
    found.yaw_rate = before(yaw_rate);
    if (std::abs(found.yaw_rate) < kLeastFreeTurn) {
        notFound(fmt::format("the car turns at {:.2g} deg/s before the release, expected at least {:.2g} deg/s",
                             kDegrees * std::abs(found.yaw_rate), kDegrees * kLeastFreeTurn));
    }
    found.speed = before(speed(log));
    found.ay = before(needed[3]);
    found.steering = before(needed[1]);
    found.first = at(yaw_rate, *release + kFirst) / found.yaw_rate;
    found.overshoot = overshootOf(yaw_rate, *release, found.yaw_rate);
    found.settling = settlingOf(yaw_rate, *release, kSettled * std::abs(found.yaw_rate));
    found.steering_overshoot = overshootOf(needed[1], *release, found.steering);
    found.last_steering = needed[1].value.back();
    return found;
}

}  // namespace

Manoeuvre freeSteer() {
    return {"free_steer",
            "hands off the wheel in a steady turn: how the car returns to straight running (after ISO 17288-1)",
            [] { return definitions(freeSteerTable()); },
            [](const Log& log, const KnownCar&) { return values(freeSteerTable(), findFreeSteer(log)); }};
}

}  // namespace tread
