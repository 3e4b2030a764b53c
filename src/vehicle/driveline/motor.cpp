#include <algorithm>
#include <cmath>

#include "tread/engine.h"

namespace tread {
namespace {

// The two ends of the pedal, and what the motor could recover more.
struct Range {
    double full;    // N m, at full throttle
    double closed;  // N m, at closed throttle, without drag: not positive
    double most;    // N m, that it can recover
    double drag;    // N m
};

Range rangeAt(const MotorParams& motor, double speed) {
    const double size = std::abs(speed);
    const double most = size * motor.torque > motor.power ? motor.power / size : motor.torque;
    const double moving = std::clamp(speed / motor.regeneration_speed, -1.0, 1.0);
    const double recover = most * std::max(moving, 0.0);
    return {speed >= motor.speed_limit ? 0 : most, -motor.lift_off_regeneration * recover, recover,
            motor.drag(size) * moving};
}

}  // namespace

MotorTorque motorTorque(const MotorParams& motor, double throttle, double brake, double speed) {
    const Range r = rangeAt(motor, speed);
    const double pedal = throttle * r.full + (1 - throttle) * r.closed;
    const double for_brake = std::clamp(brake, 0.0, std::max(r.most + std::min(pedal, 0.0), 0.0));
    return {pedal - for_brake - r.drag, for_brake};
}

double throttleFor(const MotorParams& motor, double torque, double speed) {
    const Range r = rangeAt(motor, speed);
    return r.full > r.closed ? (torque + r.drag - r.closed) / (r.full - r.closed) : 0;
}

}  // namespace tread
