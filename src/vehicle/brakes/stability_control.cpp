#include "tread/stability_control.h"

#include <algorithm>
#include <cmath>

#include "base/math/lag.h"

namespace tread {

PerWheel<double> advance(StabilityControlState& state, const StabilityControlParams& params,
                         const StabilityControlInput& in, double dt) {
    const double share = authority(params);
    if (share == 0) return {};

    // What the driver asks for.
    const double speed = std::max(in.speed, params.lowest_speed);
    const double limit = params.lateral_acceleration_limit / speed;
    const double steady = speed * in.steer / (in.wheelbase + params.understeer_gradient * speed * speed);
    const double before = state.target;
    state.target = std::clamp(steady, -limit, limit);
    state.reference = lagged(state.reference, before, state.target, params.lag, dt);

    state.since_sample += dt;
    if (state.since_sample < params.period) return state.torque;
    state.since_sample = state.since_sample < 2 * params.period ? state.since_sample - params.period : 0;

    // One wheel, on the side to which the car shall turn.
    state.torque = {};
    const double error = in.yaw_rate - state.reference;
    const double beyond = std::abs(error) - params.threshold;
    if (in.speed < params.lowest_speed || beyond <= 0) return state.torque;
    const bool oversteers = error * in.yaw_rate > 0;
    const std::size_t right = error > 0 ? 1 : 0;
    state.torque[(oversteers ? 0 : 2) + right] = share * std::min(params.gain * beyond, params.largest);
    return state.torque;
}

}  // namespace tread
