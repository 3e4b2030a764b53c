// Power-off in a steady turn, after ISO 9816.

#include <fmt/format.h>

#include <algorithm>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/turn_disturbance.h"

namespace tread {
namespace {

constexpr double kLeastThrottle = 0.03;     // of the pedal: less drives no turn
constexpr double kThrottleReleased = 0.02;  // of the pedal
constexpr double kQuickest = 1.0;           // s from the throttle before to none
constexpr double kStaysOff = 1.0;           // s

// When the foot leaves the throttle for good.
double releaseOf(const TimeSeries& throttle) {
    const auto off = lastCrossing(throttle, kThrottleReleased, throttle.begin(), throttle.end());
    if (!off || throttle.value.back() > kThrottleReleased) notFound("the throttle is not released and kept released");
    if (throttle.end() - *off < kStaysOff)
        notFound(fmt::format("the log ends {:.2g} s after the throttle is released, expected at least {:.2g} s",
                             throttle.end() - *off, kStaysOff));
    const double before = mean(throttle, *off - 2 * kQuickest, *off - kQuickest);
    if (before < kLeastThrottle) notFound(fmt::format("the throttle is only at {:.2g} before it is released", before));
    return lastCrossing(throttle, 0.5 * (before + kThrottleReleased), throttle.begin(), *off).value_or(*off);
}

TurnDisturbance findPowerOff(const Log& log) {
    const double release = releaseOf(channels(log, {"driver.throttle"}).front());
    if (const auto brake = channelIfThere(log, "driver.brake")) {
        const TimeSeries after = part(*brake, release, brake->end());
        if (*std::max_element(after.value.begin(), after.value.end()) > kRestingFoot)
            notFound("the car is braked as well");
    }
    return turnDisturbance(log, release, log.channels.front().values.back());
}

MetricTable<TurnDisturbance> powerOffTable() {
    return turnDisturbanceTable("throttle is released", {}, {3, "sideslip changes by {} deg", 2});
}

}  // namespace

Manoeuvre powerOff() {
    return {"power_off",
            "the throttle released in a steady turn: yaw rate, sideslip and path a second later (after ISO 9816)",
            [] { return definitions(powerOffTable()); },
            [](const Log& log, const KnownCar&) { return values(powerOffTable(), findPowerOff(log)); }};
}

}  // namespace tread
