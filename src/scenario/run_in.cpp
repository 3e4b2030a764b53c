#include "scenario/run_in.h"

#include <cmath>
#include <utility>

namespace tread {
namespace {

constexpr double kRunIn = 3;            // s: roll and sideslip have settled
constexpr double kRunInSteering = 1.5;  // s of these, in which the steering wheel is turned
constexpr double kInTurn = 0.03;        // rad/s
constexpr double kFirstMoment = 0.1;    // s, over which the yaw rate is averaged
constexpr double kRolling = 0.3;        // m/s: below, a car stands

}  // namespace

bool beginsInTurn(double speed, std::span<const double> time, std::span<const double> yaw_rate) {
    if (speed < kRolling) return false;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < time.size() && time[i] < time.front() + kFirstMoment; ++i) {
        if (std::isfinite(yaw_rate[i])) sum += yaw_rate[i], count += 1;
    }
    return count > 0 && std::abs(sum / count) > kInTurn;
}

void runIntoTurn(Scenario& scenario) {
    Phase phase;
    phase.name = "into the turn";
    if (const auto* steering = std::get_if<Table<Angle>>(&scenario.phases.front().steering))
        phase.steering = Table<Angle>{Curve{{{0, 0}, {kRunInSteering, steering->points(0)}}}};
    if (commandsForce(scenario.phases.front().throttle))
        phase.throttle = FollowSpeed{Curve{{{0, scenario.start.speed}}}};
    else phase.throttle = HoldSpeed{.brake = 0.5};
    phase.until.duration = scenario.start.run_in = kRunIn;
    scenario.phases.insert(scenario.phases.begin(), std::move(phase));
}

}  // namespace tread
