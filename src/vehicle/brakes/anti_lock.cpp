#include "tread/anti_lock.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

using Phase = AntiLockState::Phase;
using Wheel = AntiLockState::Wheel;

// What the valve does until the next sample.
Phase next(const Wheel& wheel, const AntiLockParams& params, double slip, double demand) {
    const bool recovers = slip < wheel.slip;
    switch (wheel.phase) {
        case Phase::idle:
            return slip > params.dump_slip ? Phase::dump : Phase::idle;
        case Phase::dump:
            return recovers ? Phase::hold : Phase::dump;
        case Phase::hold:
            if (slip < params.build_slip) return Phase::build;
            return slip > params.dump_slip && !recovers ? Phase::dump : Phase::hold;
        case Phase::build:
            if (slip > params.dump_slip) return Phase::dump;
            return wheel.pressure >= demand ? Phase::idle : Phase::build;
    }
    return Phase::idle;
}

void sample(AntiLockState& state, const AntiLockParams& params, const PerWheel<double>& demand,
            const PerWheel<double>& speed, const PerWheel<double>& rolling) {
    PerWheel<double> slip;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const double along = std::abs(speed[i]);
        slip[i] = along > 0 ? (along - std::copysign(rolling[i], rolling[i] * speed[i])) / along : 0;
    }
    if (params.select_low) slip.rear_left = slip.rear_right = std::max(slip.rear_left, slip.rear_right);
    for (std::size_t i = 0; i < kWheels; ++i) {
        Wheel& wheel = state.wheels[i];
        const bool slow = std::abs(speed[i]) < params.lowest_speed;
        const Phase phase = slow || demand[i] <= 0 ? Phase::idle : next(wheel, params, slip[i], demand[i]);
        if (wheel.phase == Phase::idle) wheel.pressure = demand[i];
        wheel.phase = phase;
        wheel.slip = slip[i];
    }
}

}  // namespace

PerWheel<double> advance(AntiLockState& state, const AntiLockParams& params, const PerWheel<double>& demand,
                         const PerWheel<double>& speed, const PerWheel<double>& rolling, double dt) {
    const double share = authority(params);
    if (share == 0) return demand;
    state.since_sample += dt;
    if (state.since_sample >= params.period) {
        state.since_sample = state.since_sample < 2 * params.period ? state.since_sample - params.period : 0;
        sample(state, params, demand, speed, rolling);
    }
    PerWheel<double> pressure;
    for (std::size_t i = 0; i < kWheels; ++i) {
        Wheel& wheel = state.wheels[i];
        if (wheel.phase == Phase::dump) wheel.pressure -= params.dump_rate * dt;
        if (wheel.phase == Phase::build) wheel.pressure += params.build_rate * dt;
        wheel.pressure = std::clamp(wheel.pressure, 0.0, demand[i]);
        pressure[i] = demand[i];
        if (wheel.phase != Phase::idle) pressure[i] = std::lerp(demand[i], wheel.pressure, share);
    }
    return pressure;
}

int regulatedWheels(const AntiLockState& state) {
    int count = 0;
    for (std::size_t i = 0; i < kWheels; ++i) count += state.wheels[i].phase != Phase::idle;
    return count;
}

}  // namespace tread
