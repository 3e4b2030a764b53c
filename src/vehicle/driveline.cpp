#include "tread/driveline.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

// The clutch closes with engine speed, as a driver or an automatic clutch would: open at idle, closed well above.
constexpr double kClutchOpens = 1.05;   // times idle speed
constexpr double kClutchCloses = 1.50;  // times idle speed
constexpr double kIdleControl = 2.0;    // N m per rad/s below idle speed
constexpr double kIdleTorque = 60;      // N m, most that the idle control gives
constexpr double kShiftPause = 1.0;     // s between shifts
// A gearbox that turns more slowly than this stands: what loads it drives the car, though it may tremble.
constexpr double kStandingGearbox = 1.0;  // rad/s
// At closed throttle the next gear is taken at this share of the full-throttle shift speed.
constexpr double kRelaxedShift = 0.45;

double totalRatio(const GearboxParams& gearbox, int gear) {
    return gearbox.ratios[static_cast<std::size_t>(gear - 1)] * gearbox.final_drive;
}

int gears(const GearboxParams& gearbox) {
    return static_cast<int>(gearbox.ratios.size());
}

double engineTorque(const EngineParams& engine, double throttle, double speed) {
    const double drag = engine.drag(speed);
    if (speed >= engine.speed_limit) return -drag;
    const double idle = std::clamp(kIdleControl * (engine.idle_speed - speed), 0.0, kIdleTorque);
    return throttle * (engine.full_load(speed) + drag) - drag + (speed < engine.idle_speed ? idle + drag : 0);
}

void shift(DrivelineState& state, const GearboxParams& gearbox, double throttle, double dt) {
    state.since_shift += dt;
    if (state.since_shift < kShiftPause) return;
    const double up = gearbox.shift_up_speed * (kRelaxedShift + (1 - kRelaxedShift) * throttle);
    int gear = state.gear;
    if (state.gearbox_speed > up && gear < gears(gearbox)) ++gear;
    if (state.gearbox_speed < gearbox.shift_down_speed && gear > 1) --gear;
    if (gear == state.gear) return;
    state.gearbox_speed *= totalRatio(gearbox, gear) / totalRatio(gearbox, state.gear);
    state.gear = gear;
    state.since_shift = 0;
}

double meanSpin(const PerWheel<double>& spin, double front_share) {
    return 0.5 * (front_share * (spin.front_left + spin.front_right) +
                  (1 - front_share) * (spin.rear_left + spin.rear_right));
}

PerAxle<double> split(double torque, double front_share) {
    return {.front = 0.5 * front_share * torque, .rear = 0.5 * (1 - front_share) * torque};
}

double clutchCapacity(const DrivelineParams& params, double engine_speed, double pedal) {
    const double idle = params.engine.idle_speed;
    const double closed = (engine_speed / idle - kClutchOpens) / (kClutchCloses - kClutchOpens);
    return params.gearbox.clutch_torque * std::clamp(closed, 0.0, 1.0) * (1 - pedal);
}

}  // namespace

DrivelineTorques advance(DrivelineState& state, const DrivelineParams& params, const DrivelineInput& input, double dt) {
    const EngineParams& engine = params.engine;
    const GearboxParams& gearbox = params.gearbox;
    shift(state, gearbox, input.throttle, dt);
    const double ratio = totalRatio(gearbox, state.gear);

    // Shafts: a torsional spring between gearbox and wheels, by the implicit midpoint rule: stable for any stiffness
    // and inertia. The gearbox's mean speed over the step is then free + per_torque * (torque of the clutch).
    const double wheels = meanSpin(input.wheel_spin, params.front_share);
    const auto shaftTorque = [&](double gearbox_speed, double step) {
        const double rate = gearbox_speed / ratio - wheels;
        return params.shaft_stiffness * (state.twist + step * rate) + params.shaft_damping * rate;
    };
    const double half = 0.5 * dt;
    const double direction = shaftTorque(state.gearbox_speed, 0) < 0 ? -1 : 1;
    const bool driving = direction * state.gearbox_speed > -kStandingGearbox;
    const double loss = driving ? gearbox.efficiency : 1 / gearbox.efficiency;
    const double impedance = (params.shaft_damping + params.shaft_stiffness * half) / (ratio * ratio * loss);
    const double per_torque = half / (gearbox.inertia + half * impedance);
    const double free = (gearbox.inertia * state.gearbox_speed - half * shaftTorque(0, half) / (ratio * loss)) /
                        (gearbox.inertia + half * impedance);

    // Clutch: the torque that makes both sides equally fast at the end, as far as the clutch holds it.
    const double torque = engineTorque(engine, input.throttle, state.engine_speed);
    const double engine_speed = state.engine_speed + dt * torque / engine.inertia;
    const double gearbox_speed = 2 * free - state.gearbox_speed;
    const double needed = (engine_speed - gearbox_speed) / (dt / engine.inertia + 2 * per_torque);
    const double capacity = clutchCapacity(params, state.engine_speed, input.clutch_pedal);
    const double clutch = std::clamp(needed, -capacity, capacity);

    const double mean = free + per_torque * clutch;
    const double shaft = shaftTorque(mean, half);
    state.engine_speed = std::max(engine_speed - dt * clutch / engine.inertia, 0.0);
    state.gearbox_speed = 2 * mean - state.gearbox_speed;
    state.twist += dt * (mean / ratio - wheels);
    return {split(shaft, params.front_share), torque};
}

SteadyDriveline steadyDriveline(const DrivelineParams& params, double wheel_spin, double wheel_torque) {
    const GearboxParams& gearbox = params.gearbox;
    SteadyDriveline steady;
    DrivelineState& state = steady.state;

    // The highest gear that keeps the engine comfortably above the speed at which it would shift down.
    constexpr double kReserve = 1.15;
    state.gear = gears(gearbox);
    while (state.gear > 1 && wheel_spin * totalRatio(gearbox, state.gear) < kReserve * gearbox.shift_down_speed)
        --state.gear;
    const double ratio = totalRatio(gearbox, state.gear);
    state.gearbox_speed = std::abs(wheel_spin) * ratio;
    state.engine_speed = std::max(state.gearbox_speed, params.engine.idle_speed);
    state.since_shift = kShiftPause;
    state.twist = wheel_torque / params.shaft_stiffness;

    const double loss = wheel_torque > 0 ? gearbox.efficiency : 1 / gearbox.efficiency;
    const double drag = params.engine.drag(state.engine_speed);
    const double full = params.engine.full_load(state.engine_speed) + drag;
    steady.throttle = full > 0 ? (wheel_torque / (ratio * loss) + drag) / full : 0;
    return steady;
}

}  // namespace tread
