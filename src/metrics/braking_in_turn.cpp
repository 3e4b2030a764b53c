// Braking in a steady turn, after ISO 7975.

#include <fmt/format.h>

#include <algorithm>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/turn_disturbance.h"

namespace tread {
namespace {

constexpr std::string_view kName = "braking_in_turn";
constexpr double kLeastBrake = 0.02;  // of the pedal: less is a resting foot
constexpr double kReleased = 0.1;     // of the largest pedal: the braking is over

TurnDisturbance findBraking(const Log& log) {
    const TimeSeries brake = channels(log, kName, {"driver.brake"}).front();
    const double most = *std::max_element(brake.value.begin(), brake.value.end());
    if (most < kLeastBrake) notFound(kName, "the brake is never applied");
    const auto onset = firstCrossing(brake, kLeastBrake, brake.begin());
    if (!onset || brake.value.front() > kLeastBrake) notFound(kName, "the brake is on from the beginning");
    const double peak = highest(brake, *onset, brake.end()).time;
    return turnDisturbance(log, kName, *onset, firstCrossing(brake, kReleased * most, peak).value_or(brake.end()));
}

MetricTable<TurnDisturbance> table() {
    return turnDisturbanceTable("brake is applied", {1, "decelerates at {} m/s2", 2}, {});
}

}  // namespace

Manoeuvre brakingInTurn() {
    return {kName, "braking in a steady turn: yaw rate, sideslip and path a second later (after ISO 7975)",
            [] { return definitions(table()); },
            [](const Log& log, const KnownCar&) { return values(table(), findBraking(log)); }};
}

}  // namespace tread
