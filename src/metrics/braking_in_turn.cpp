// Braking in a steady turn, after ISO 7975.

#include <fmt/format.h>

#include <algorithm>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/turn_disturbance.h"

namespace tread {
namespace {

constexpr double kBrakeReleased = 0.1;  // of the largest pedal: the braking is over

TurnDisturbance findBrakingInTurn(const Log& log) {
    const TimeSeries brake = channels(log, {"driver.brake"}).front();
    const double most = *std::max_element(brake.value.begin(), brake.value.end());
    if (most < kRestingFoot) notFound("the brake is never applied");
    const auto onset = firstCrossing(brake, kRestingFoot, brake.begin());
    if (!onset || brake.value.front() > kRestingFoot) notFound("the brake is on from the beginning");
    const double peak = highest(brake, *onset, brake.end()).time;
    return turnDisturbance(log, *onset, firstCrossing(brake, kBrakeReleased * most, peak).value_or(brake.end()));
}

MetricTable<TurnDisturbance> brakingInTurnTable() {
    return turnDisturbanceTable("brake is applied", {1, "decelerates at {} m/s2", 2}, {});
}

}  // namespace

Manoeuvre brakingInTurn() {
    return {"braking_in_turn", "braking in a steady turn: yaw rate, sideslip and path a second later (after ISO 7975)",
            [] { return definitions(brakingInTurnTable()); },
            [](const Log& log, const KnownCar&) { return values(brakingInTurnTable(), findBrakingInTurn(log)); }};
}

}  // namespace tread
