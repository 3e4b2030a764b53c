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
    const double by_voltage = motor.no_load_speed > 0 ? motor.torque * (1 - speed / motor.no_load_speed) : most;
    const double full = speed >= motor.speed_limit ? 0 : std::clamp(by_voltage, 0.0, most);
    return {full, -motor.lift_off_regeneration * recover, recover, motor.drag(size) * moving};
}

}  // namespace

MotorTorque motorTorque(const MotorParams& motor, double throttle, double brake, double speed) {
    const Range r = rangeAt(motor, speed);
    const double band = motor.throttle_dead_band;
    const double open = std::max(throttle - band, 0.0) / (1 - band);
    const double pedal = open * r.full + (1 - open) * r.closed;
    const double for_brake = std::clamp(brake, 0.0, std::max(r.most + std::min(pedal, 0.0), 0.0));
    return {pedal - for_brake - r.drag, for_brake};
}

double throttleFor(const MotorParams& motor, double torque, double speed) {
    const Range r = rangeAt(motor, speed);
    if (r.full <= r.closed) return 0;
    const double open = (torque + r.drag - r.closed) / (r.full - r.closed), band = motor.throttle_dead_band;
    return band > 0 && open > 0 ? band + open * (1 - band) : open;
}

}  // namespace tread
