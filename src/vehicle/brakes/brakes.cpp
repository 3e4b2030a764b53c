#include "tread/brakes.h"

#include <algorithm>
#include <cmath>

#include "base/math/delay_line.h"
#include "base/math/elementary.h"
#include "base/math/lag.h"

namespace tread {
namespace {

double axleShare(const BrakeParams& params, std::size_t axle) {
    return axle == 0 ? params.front_share : 1 - params.front_share;
}

const DiscParams& discOf(const BrakeParams& params, std::size_t axle) {
    return axle == 0 ? params.front_disc : params.rear_disc;
}

// Pressures as shares of that at full pedal.
PerWheel<double> shares(const BrakeParams& params, double pedal) {
    const double knee = params.rear_proportioning.knee / params.full_pedal_pressure;
    const double rear = pedal <= knee ? pedal : knee + params.rear_proportioning.slope * (pedal - knee);
    return {pedal, pedal, rear, rear};
}

double torqueOf(const BrakeParams& params, double share, std::size_t axle) {
    return 0.5 * (params.full_pedal_torque * share) * axleShare(params, axle);
}

// What the controllers make of the driver's wish, and the hydraulics of that.
PerWheel<double> controlled(BrakeState& state, const BrakeParams& params, PerWheel<double> wish, const BrakeInput& in,
                            double dt) {
    const PerWheel<double> single = advance(state.stability_control, params.stability_control, in.car, dt);
    for (std::size_t i = 0; i < kWheels; ++i) {
        const double full = torqueOf(params, 1, axleOf(i));
        wish[i] += full > 0 ? single[i] / full : 0;
        wish[i] *= params.full_pedal_pressure;
    }
    const PerWheel<double> before = state.asked;
    state.asked = advance(state.anti_lock, params.anti_lock, wish, in.speed, in.rolling, dt);
    PerWheel<double> pressure;
    for (std::size_t i = 0; i < kWheels; ++i) {
        pressure[i] = lagged(state.pressure[i], before[i], state.asked[i], params.lag, dt);
        pressure[i] /= params.full_pedal_pressure;
    }
    return pressure;
}

// Backward Euler: steady for any step.
void heat(double& heating, const DiscParams& disc, double power, double speed, double dt) {
    if (disc.heat_capacity == 0) return;
    const double cooling = disc.cooling + disc.cooling_by_speed * std::abs(speed);
    heating = (heating + dt * power / disc.heat_capacity) / (1 + dt * cooling / disc.heat_capacity);
}

}  // namespace

BrakeTorques advance(BrakeState& state, const BrakeParams& params, const BrakeInput& in, double dt) {
    // Pedal, and the pressures that follow it.
    const bool follows_at_once = params.delay == 0 && params.lag == 0 && authority(params.anti_lock) == 0 &&
                                 authority(params.stability_control) == 0;
    PerWheel<double> begin, end;
    if (follows_at_once) {
        begin = shares(params, in.pedal_begin);
        end = shares(params, in.pedal_end);
    } else {
        const double pedal =
            params.delay == 0 ? in.pedal_end : advance(state.pedal, in.pedal_begin, in.pedal_end, params.delay, dt);
        for (std::size_t i = 0; i < kWheels; ++i) begin[i] = state.pressure[i] / params.full_pedal_pressure;
        end = controlled(state, params, shares(params, pedal), in, dt);
    }

    // Torques, with the friction of the hot disc, less what a motor brakes; the parking brake; what is commanded; drag.
    BrakeTorques torques;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const std::size_t axle = axleOf(i);
        const DiscParams& disc = discOf(params, axle);
        const double heating = state.heating[i];
        double friction = disc.friction.empty() ? 1 : disc.friction(params.ambient_temperature + heating);
        if (disc.fade != 0) friction *= exponential(-disc.fade * heating);
        const auto torque = [&](double share, double parking) {
            const double hydraulic = std::max(torqueOf(params, share, axle) - in.recovered[axle], 0.0);
            return friction * (hydraulic + (axle == 0 ? 0 : 0.5 * params.parking_torque * parking)) + in.commanded[i] +
                   in.drag[i];
        };
        torques.end[i] = torque(end[i], in.parking_end);
        torques.mean[i] = torque(0.5 * (begin[i] + end[i]), 0.5 * (in.parking_begin + in.parking_end));
        state.pressure[i] = end[i] * params.full_pedal_pressure;
        heat(state.heating[i], disc, torques.mean[i] * std::abs(in.spin[i]), in.car.speed, dt);
    }
    return torques;
}

}  // namespace tread
