#include "scenario/driver.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

#include "base/did_you_mean.h"

namespace tread {
namespace {

constexpr double kTimeRounding = 1e-9;  // s: a phase that ends at a step's end ends in it

std::string shortNumber(double value) {
    constexpr double kNothing = 5e-4;  // of any unit
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", std::abs(value) < kNothing ? 0 : value);
    return text;
}

}  // namespace

Driver::Driver(const Scenario& scenario, const VehicleInput& initial) : scenario_(scenario), held_(initial) {}

void Driver::look(double time, const ChassisOutput& chassis, double hand_wheel_angle) {
    if (looked_) {
        const double dt = time - seen_time_;
        phase_distance_ += dt * std::hypot(chassis.vx, chassis.vy);
        if (const auto* hold = std::get_if<HoldSpeed>(&phase().throttle)) {
            missing_way_ += dt * ((hold->speed > 0 ? hold->speed : phase_speed_) - chassis.vx);
            // A pedal at its end asks for no more: what piled up there would have to be driven off again.
            if (hold->integral > 0) {
                missing_way_ =
                    std::clamp(missing_way_, -held_.throttle / hold->integral, (1 - held_.throttle) / hold->integral);
            }
        }
    } else {
        phase_speed_ = chassis.vx;
    }
    looked_ = true;
    seen_ = chassis;
    seen_hand_wheel_ = hand_wheel_angle;
    seen_time_ = time;
    if (!ended_ && conditionTrue()) next(time);
}

bool Driver::conditionTrue() const {
    const Until& until = phase().until;
    return (until.speed_below && seen_.vx < *until.speed_below) ||
           (until.speed_above && seen_.vx > *until.speed_above) ||
           (until.lateral_acceleration_above && std::abs(seen_.ay) > *until.lateral_acceleration_above) ||
           (until.distance && phase_distance_ > *until.distance);
}

void Driver::next(double time) {
    if (last()) {
        ended_ = true;
        return;
    }
    held_ = signals(time);
    ++phase_;
    phase_start_ = time;
    phase_distance_ = 0;
    phase_speed_ = seen_.vx;
    missing_way_ = 0;
}

VehicleInput Driver::signals(double time) const {
    const Phase& now = phase();
    const double elapsed = time - phase_start_;
    VehicleInput input;
    input.steering_wheel_angle = valueAt(now.steering, held_.steering_wheel_angle, elapsed);
    if (std::holds_alternative<HandsOff>(now.steering)) {
        input.hands_off = 1;
        input.steering_wheel_angle = seen_hand_wheel_;  // where the hands would find it
    }
    input.throttle = valueAt(now.throttle, held_.throttle, elapsed);
    input.brake = valueAt(now.brake, held_.brake, elapsed);
    input.clutch = valueAt(now.clutch, held_.clutch, elapsed);
    input.parking_brake = valueAt(now.parking_brake, held_.parking_brake, elapsed);
    if (const auto* hold = std::get_if<HoldSpeed>(&now.throttle)) {
        const double missing = (hold->speed > 0 ? hold->speed : phase_speed_) - seen_.vx;
        input.throttle = held_.throttle + hold->proportional * missing + hold->integral * missing_way_;
    }
    input.throttle = std::clamp(input.throttle, 0.0, 1.0);
    return input;
}

VehicleInput Driver::inputAt(double time) {
    while (!last() && phase().until.duration && time > phase_start_ + *phase().until.duration + kTimeRounding) {
        next(phase_start_ + *phase().until.duration);
    }
    return signals(time);
}

bool Driver::finished(double time) const {
    return ended_ ||
           (last() && phase().until.duration && time >= phase_start_ + *phase().until.duration - kTimeRounding);
}

std::string Driver::waitsFor() const {
    const Until& until = phase().until;
    std::vector<std::string> ends;
    if (until.speed_below) ends.push_back("a speed below " + shortNumber(*until.speed_below) + " m/s");
    if (until.speed_above) ends.push_back("a speed above " + shortNumber(*until.speed_above) + " m/s");
    if (until.lateral_acceleration_above)
        ends.push_back("a lateral acceleration above " + shortNumber(*until.lateral_acceleration_above) + " m/s2");
    if (until.distance) ends.push_back("a way of " + shortNumber(*until.distance) + " m");
    if (until.duration) ends.push_back(shortNumber(*until.duration) + " s to pass");

    const bool named = !phase().name.empty();
    return (named ? "phase \"" + phase().name + "\"" : "phases." + std::to_string(phase_)) + " waits for " +
           listed(std::vector<std::string_view>(ends.begin(), ends.end())) + "; the car has " + shortNumber(seen_.vx) +
           " m/s and " + shortNumber(std::abs(seen_.ay)) + " m/s2 to the side";
}

}  // namespace tread
