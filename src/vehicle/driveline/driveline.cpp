#include "tread/driveline.h"

#include <algorithm>
#include <cmath>

#include "base/math/elementary.h"
#include "vehicle/driveline/coupling.h"
#include "vehicle/driveline/differential.h"
#include "vehicle/driveline/gearbox.h"

namespace tread {
namespace {

// A gearbox that turns more slowly than this stands: what loads it drives the car, though it may tremble.
constexpr double kStandingGearbox = 1.0;  // rad/s
// While the clutch is open in a shift, the engine is revved up to the gearbox's speed: full throttle when it lacks
// this.
constexpr double kRevMatching = 50;  // rad/s

double meanSpin(const PerWheel<double>& spin, double front_share) {
    return 0.5 * (front_share * (spin.front_left + spin.front_right) +
                  (1 - front_share) * (spin.rear_left + spin.rear_right));
}

double follow(double value, double target, double time_constant, double dt) {
    return time_constant == 0 ? target : target + (value - target) * exponential(-dt / time_constant);
}

double motorInertia(const DrivelineParams& params) {
    return params.motor ? params.motor->inertia : 0;
}

// A commanded torque goes to the wheels as that of the shafts does. Engine and gearbox turn along without torque, the
// shafts are twisted by it: when the command ends, the driveline goes on from there.
DrivelineTorques commanded(DrivelineState& state, const DrivelineParams& params, const DrivelineInput& input,
                           double dt) {
    const double torque = *input.commanded;
    shift(state, params.gearbox, 0, dt);
    state.gearbox_speed = totalRatio(params.gearbox, state.gear) * meanSpin(input.wheel_spin, params.front_share);
    state.engine_speed = params.engine ? std::max(state.gearbox_speed, params.engine->idle_speed) : state.gearbox_speed;
    state.engine_throttle = state.motor_throttle = 0;
    state.twist = torque / params.shaft_stiffness;
    return {.wheel = sharedTorque(params, input, torque, dt), .engine = 0, .motor = 0, .braked = {}};
}

}  // namespace

DrivelineTorques advance(DrivelineState& state, const DrivelineParams& params, const DrivelineInput& input, double dt) {
    if (input.commanded) return commanded(state, params, input, dt);
    const GearboxParams& gearbox = params.gearbox;
    shift(state, gearbox, input.throttle, dt);
    const double ratio = totalRatio(gearbox, state.gear);

    // Motor, with what it takes over from the brakes.
    MotorTorque motor{0, 0};
    if (params.motor) {
        const double taken = params.motor->brake_regeneration * input.brake_torque * gearbox.efficiency / ratio;
        state.motor_throttle = follow(state.motor_throttle, input.throttle, params.motor->response_time, dt);
        motor = motorTorque(*params.motor, state.motor_throttle, taken, state.gearbox_speed);
    }

    // Shafts: a torsional spring between gearbox and wheels, by the implicit midpoint rule: stable for any stiffness
    // and inertia. The gearbox's mean speed over the step is then free + per_torque * (torque of the coupling).
    const double wheels = meanSpin(input.wheel_spin, params.front_share);
    const auto shaftTorque = [&](double gearbox_speed, double step) {
        const double rate = gearbox_speed / ratio - wheels;
        return params.shaft_stiffness * (state.twist + step * rate) + params.shaft_damping * rate;
    };
    const double half = 0.5 * dt;
    const double inertia = gearbox.inertia + motorInertia(params);
    const double direction = shaftTorque(state.gearbox_speed, 0) < 0 ? -1 : 1;
    const bool driving = direction * state.gearbox_speed > -kStandingGearbox;
    const double loss = driving ? gearbox.efficiency : 1 / gearbox.efficiency;
    const double impedance = (params.shaft_damping + params.shaft_stiffness * half) / (ratio * ratio * loss);
    const double per_torque = half / (inertia + half * impedance);
    const double free =
        (inertia * state.gearbox_speed - half * shaftTorque(0, half) / (ratio * loss) + half * motor.total) /
        (inertia + half * impedance);

    // Engine and what couples it.
    double engine_torque = 0, mean = free;
    if (params.engine) {
        const EngineParams& engine = *params.engine;
        const double closed = engagement(state, gearbox);
        const double blip = std::clamp((state.gearbox_speed - state.engine_speed) / kRevMatching, 0.0, 1.0);
        const double throttle = closed * input.throttle + (1 - closed) * blip;
        state.engine_throttle = follow(state.engine_throttle, throttle, engine.response_time, dt);
        engine_torque = engineTorque(engine, state.engine_throttle, state.engine_speed);
        const double engine_speed = state.engine_speed + dt * engine_torque / engine.inertia;
        const double gearbox_speed = 2 * free - state.gearbox_speed;
        const CouplingTorques link = coupled(
            params, state,
            {engine_speed, gearbox_speed, dt / engine.inertia, 2 * per_torque, (1 - input.clutch_pedal) * closed});
        mean = free + per_torque * link.gearbox;
        state.engine_speed = std::max(engine_speed - dt * link.engine / engine.inertia, 0.0);
    }

    const double shaft = shaftTorque(mean, half);
    state.gearbox_speed = 2 * mean - state.gearbox_speed;
    state.twist += dt * (mean / ratio - wheels);
    if (!params.engine) state.engine_speed = state.gearbox_speed;

    const double braked = 0.5 * motor.for_brake * ratio / gearbox.efficiency;
    return {.wheel = sharedTorque(params, input, shaft, dt),
            .engine = engine_torque,
            .motor = motor.total,
            .braked = {braked * params.front_share, braked * (1 - params.front_share)}};
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
    state.since_shift = shiftPause(gearbox);

    const double loss = wheel_torque > 0 ? gearbox.efficiency : 1 / gearbox.efficiency;
    const double torque = wheel_torque / (ratio * loss);
    if (!params.engine) {
        state.engine_speed = state.gearbox_speed;
        state.twist = wheel_torque / params.shaft_stiffness;
        steady.throttle = throttleFor(*params.motor, torque, state.gearbox_speed);
        state.motor_throttle = std::clamp(steady.throttle, 0.0, 1.0);
        return steady;
    }

    // With a motor beside it, both follow the same pedal: the engine's share is what the motor leaves.
    const bool creeps =
        state.gearbox_speed < kStandingGearbox && std::holds_alternative<TorqueConverterParams>(params.coupling);
    double motor = 0;
    for (int i = 0; i < (params.motor ? 40 : 1); ++i) {
        const SteadyCoupling link = steadyCoupling(params, state.gearbox_speed, state.gear, torque - motor, creeps);
        state.engine_speed = link.engine_speed;
        const double shaft = creeps ? (link.gearbox_torque + motor) * ratio * gearbox.efficiency : wheel_torque;
        state.twist = shaft / params.shaft_stiffness;
        steady.throttle = throttleFor(*params.engine, link.engine_torque, link.engine_speed);
        state.engine_throttle = std::clamp(steady.throttle, 0.0, 1.0);
        if (!params.motor) break;
        state.motor_throttle = state.engine_throttle;
        const double next = motorTorque(*params.motor, state.motor_throttle, 0, state.gearbox_speed).total;
        motor += 0.5 * (next - motor);
    }
    return steady;
}

}  // namespace tread
