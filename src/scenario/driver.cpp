#include "scenario/driver.h"

#include <algorithm>
#include <cmath>

#include "base/fields/numbers.h"
#include "base/math/elementary.h"
#include "scenario/expression/parse.h"
#include "scenario/replay.h"

namespace tread {
namespace {

constexpr double kTimeRounding = 1e-9;  // s: a phase that ends at a step's end ends in it

bool watchesCar(const SteeringSignal& signal) {
    return std::holds_alternative<HoldLateralAcceleration>(signal) || std::holds_alternative<HoldRadius>(signal) ||
           std::holds_alternative<FollowPath>(signal);
}

// The conditions of the phases, bound to their channels.
std::vector<std::optional<MomentaryExpression>> conditionsOf(const Scenario& scenario, Place& place,
                                                             const ChannelValue& channel) {
    const std::vector<Number> own = numbers(place);
    const ChannelValue find = [&](std::string_view name) -> const double* {
        const auto found = std::find_if(own.begin(), own.end(), [&](const Number& n) { return n.path == name; });
        if (found != own.end()) return found->value;
        return channel ? channel(name) : nullptr;
    };
    std::vector<std::optional<MomentaryExpression>> conditions;
    for (const Phase& phase : scenario.phases) {
        ExpressionFault fault;
        const auto term = phase.until.when ? parseExpression(phase.until.when.text, fault) : std::nullopt;
        conditions.push_back(term ? std::optional<MomentaryExpression>(std::in_place, *term, find) : std::nullopt);
    }
    return conditions;
}

}  // namespace

Driver::Driver(const Scenario& scenario, const VehicleInput& initial, const KnownSteering& car,
               const KnownResistance& resistance, const ChannelValue& channel, const KnownGrip& grip)
    : scenario_(withReplaysRead(scenario)),
      conditions_(conditionsOf(scenario_, *place_, channel)),
      held_(initial),
      course_(scenario_.course, grip),
      follower_(resistance),
      hands_(car, course_.path()) {
    phase_start_ = seen_time_ = -scenario_.start.run_in;
    beginPhase();
}

void Driver::beginPhase() {
    seen_.distance = 0;
    seen_.yaw_rate_before = 0;
    if (conditions_[phase_]) conditions_[phase_]->begin();
    feet_.begin(seen_.car.vx, held_.throttle);
    hands_.begin(held_.steering_wheel_angle, way_);
    phase_end_ = endByClock();
}

// Where the car is on the course. From step to step the nearest place is looked for ahead of the last one, so that a
// course may cross itself.
void Driver::findPlace() {
    if (course_.empty()) return;
    constexpr double kReach = 20;  // m: a car moves less in a step
    const Path& path = course_.path();
    const Point here{seen_.car.x, seen_.car.y};
    if (!way_) {
        way_ = path.nearest(here);
        // A car just behind the line of a closed course has its first lap yet to come.
        if (path.closed() && *way_ > 0.5 * path.length()) *way_ -= path.length();
    } else {
        way_ = path.nearest(here, *way_, kReach);
    }
    place_->course = {*way_, path.aside(here, *way_), course_.speed(*way_)};
    seen_.laps = course_.laps(*way_);
}

// Lets the feet know what a step of dt has brought.
void Driver::driveOn(double elapsed, double dt) {
    if (const auto* hold = std::get_if<HoldSpeed>(&phase().throttle)) feet_.look(*hold, seen_.car.vx, elapsed, dt);
    if (const auto* follow = std::get_if<FollowCourse>(&phase().throttle); follow && way_) {
        const double ahead = aheadOf(*follow);
        feet_.look(*follow, course_.speed(ahead) - seen_.car.vx, course_.acceleration(ahead), dt);
    }
}

void Driver::look(double time, const ChassisOutput& chassis, double steering_wheel_angle) {
    const double dt = time - seen_time_, elapsed = time - phase_start_;
    if (looked_) {
        seen_.distance += dt * hypotenuse(chassis.vx, chassis.vy);
        hands_.look(phase().steering, chassis, time, dt);
        seen_.yaw_rate_before = seen_.car.yaw_rate;
        seen_.car = chassis;
        driveOn(elapsed, dt);
    } else {
        feet_.begin(chassis.vx, held_.throttle);
    }
    looked_ = true;
    seen_.car = chassis;
    findPlace();
    seen_steering_wheel_ = steering_wheel_angle;
    if (phase().until.steering_above) seen_.steering_wheel_angle = signals(time).steering_wheel_angle;
    seen_time_ = time;
    seen_.condition = conditions_[phase_] && conditions_[phase_]->holds(time);
    if (!ended_ && happened(phase().until, seen_)) next(time);

    // A phase that ends by the clock is over from then on, though the hands go on only in the coming step.
    const bool over = phase_end_ && !last() && time >= *phase_end_ - kTimeRounding;
    place_->manoeuvre.phase = static_cast<double>(phase_ + (over ? 2 : 1));
    place_->manoeuvre.phase_start = over ? *phase_end_ : phase_start_;
}

std::optional<double> Driver::endByClock() const {
    const Until& until = phase().until;
    std::optional<double> end = until.time;
    const auto atLatest = [&](double latest) { end = std::min(end.value_or(kInfinity), latest); };
    if (until.duration) atLatest(phase_start_ + *until.duration);
    if (until.after_steering) {
        atLatest(phase_start_ + lengthOf(phase().steering, held_.steering_wheel_angle) + *until.after_steering);
    }
    return end;
}

void Driver::next(double time) {
    if (last()) {
        ended_ = true;
        return;
    }
    held_ = signals(time);
    ++phase_;
    phase_start_ = time;
    beginPhase();
}

VehicleInput Driver::signals(double time) const {
    const Phase& now = phase();
    const double elapsed = time - phase_start_;
    VehicleInput input;
    input.steering_wheel_angle =
        watchesCar(now.steering) ? hands_.angle() : valueAt(now.steering, held_.steering_wheel_angle, elapsed);
    if (std::holds_alternative<HandsOff>(now.steering)) {
        input.hands_off = 1;
        input.steering_wheel_angle = seen_steering_wheel_;  // where the hands would find it
    }
    input.throttle = valueAt(now.throttle, held_.throttle, elapsed);
    input.brake = valueAt(now.brake, held_.brake, elapsed);
    input.clutch = valueAt(now.clutch, held_.clutch, elapsed);
    input.parking_brake = valueAt(now.parking_brake, held_.parking_brake, elapsed);
    if (const auto* hold = std::get_if<HoldSpeed>(&now.throttle)) {
        const auto [throttle, brake] = feet_.pedals(*hold, seen_.car.vx, elapsed);
        input.throttle = throttle;
        input.brake = std::max(input.brake, brake);
    }
    if (const auto* follow = std::get_if<FollowCourse>(&now.throttle); follow && way_) {
        const double ahead = aheadOf(*follow);
        const auto [throttle, brake] =
            feet_.pedals(*follow, course_.speed(ahead) - seen_.car.vx, course_.acceleration(ahead));
        input.throttle = throttle;
        input.brake = std::max(input.brake, brake);
    }
    input.throttle = std::clamp(input.throttle, 0.0, 1.0);
    if (commandsForce(now.throttle)) {
        input.throttle = input.brake = 0;
        input.force_command = 1;
    }
    if (const auto* command = std::get_if<CommandedForce>(&now.throttle))
        input.longitudinal_force = command->points(elapsed);
    return input;
}

VehicleInput Driver::inputAt(double time) {
    while (phase_end_ && !last() && time > *phase_end_ + kTimeRounding) next(std::max(*phase_end_, phase_start_));
    VehicleInput input = signals(time);
    if (const auto* follow = std::get_if<FollowSpeed>(&phase().throttle)) {
        input.longitudinal_force = follower_.force(*follow, seen_.car.vx, time - phase_start_, time - seen_time_);
    } else {
        follower_.pause();
    }
    return input;
}

bool Driver::finished(double time) const {
    return ended_ || (last() && phase_end_ && time >= *phase_end_ - kTimeRounding);
}

std::string Driver::waitsFor() const {
    const bool named = !phase().name.empty();
    return (named ? "phase \"" + phase().name + "\"" : "phases." + std::to_string(phase_)) + " waits for " +
           wordsOf(phase().until) + "; the car moves at " + shortNumber(seen_.car.vx) + " m/s with " +
           shortNumber(std::abs(seen_.car.ay)) + " m/s2 of lateral acceleration";
}

}  // namespace tread
