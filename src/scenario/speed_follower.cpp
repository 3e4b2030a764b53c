#include "scenario/speed_follower.h"

#include <algorithm>

#include "base/math/elementary.h"

namespace tread {
namespace {

// Time constant with which resistances are observed: slower than tyres and suspension answer to a torque (about 0.02
// s).
constexpr double kObserving = 0.06;       // s
constexpr double kStepsObserving = 5;     // ... and no shorter than this many steps, for coarse ones
constexpr double kCorrecting = 3;         // time constant of the speed's correction over that of the observation
constexpr double kLargestCorrection = 3;  // m/s2
constexpr double kLargestResistance = 6;  // m/s2; more than a car feels that grips, so that a slide piles up little

// A car that shall be slower than this is braked besides, so that it stands still, also on a slope of 20 %.
constexpr double kStanding = 0.1;  // m/s
constexpr double kHolding = 2;     // m/s2, at a wanted speed of zero

}  // namespace

void SpeedFollower::observe(double speed) {
    if (step_ == 0 || holds_) return;
    const double acted = 0.5 * (force_before_ + force_) / car_.mass;
    const double lost = acted - (speed - speed_) / step_;
    const double time_constant = std::max(kObserving, kStepsObserving * step_);
    resistance_ += (1 - exponential(-step_ / time_constant)) * (lost - resistance_);
    resistance_ = std::clamp(resistance_, -kLargestResistance, kLargestResistance);
}

double SpeedFollower::force(const FollowSpeed& follow, double speed, double elapsed, double dt) {
    observe(speed);
    const auto& wanted = follow.profile;
    const double acceleration = (wanted(elapsed + dt) - wanted(elapsed - dt)) / (2 * dt);
    const double correction_time = kCorrecting * std::max(kObserving, kStepsObserving * dt);
    const double correction =
        std::clamp((wanted(elapsed - dt) - speed) / correction_time, -kLargestCorrection, kLargestCorrection);

    const double standing = std::max(1 - wanted(elapsed) / kStanding, 0.0);
    const double next = car_.mass * (acceleration + correction + resistance_ - kHolding * standing);
    force_before_ = step_ > 0 ? force_ : next;
    force_ = next;
    speed_ = speed;
    step_ = dt;
    holds_ = standing > 0;
    return force_;
}

}  // namespace tread
