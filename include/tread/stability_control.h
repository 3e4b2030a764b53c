// Electronic stability control: brakes single wheels when the car does not turn as its driver steers.
//
// The driver's wish is the steady yaw rate of a single-track model, v delta / (l + K v^2), at most what the friction
// allows, with a first-order lag. A car that turns in more is held by its outer front wheel, one that turns in less is
// pulled round by its inner rear wheel; the brake torque is proportional to what the error exceeds its threshold.
#pragma once

#include <algorithm>

#include "tread/api.h"
#include "tread/describe.h"
#include "tread/wheels.h"

namespace tread {

struct StabilityControlParams {
    bool enabled = false;
    double authority_offset = 0;
    double period = 0.01;
    double understeer_gradient = 0.003;
    double lateral_acceleration_limit = 8;
    double lag = 0.08;
    double threshold = 0.06;
    double gain = 12000;
    double largest = 2500;
    double lowest_speed = 5;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(enabled), About{"", "true: the car has this control"});
        field(TREAD_FIELD(authority_offset),
              About{"-",
                    "offset of the share of its intervention that reaches the brakes: 1 when enabled, else 0",
                    {-1, 1}});
        field(TREAD_FIELD(period), About{"s", "sample period of the controller", kPositive}.usually(1e-4, 0.1));
        field(TREAD_FIELD(understeer_gradient),
              About{"rad s2/m", "understeer gradient of the reference: road-wheel angle per lateral acceleration",
                    kNonNegative}
                  .usually(0, 0.02));
        field(TREAD_FIELD(lateral_acceleration_limit),
              About{"m/s2", "lateral acceleration that limits the reference yaw rate (friction)", kPositive}.usually(
                  1, 30));
        field(TREAD_FIELD(lag), About{"s", "time constant of the reference", kNonNegative}.usually(0, 1));
        field(TREAD_FIELD(threshold), About{"rad/s", "tolerated yaw-rate error", kNonNegative}.usually(0, 1));
        field(TREAD_FIELD(gain),
              About{"N m s/rad", "brake torque per yaw-rate error beyond the threshold", kNonNegative}.usually(0, 1e6));
        field(TREAD_FIELD(largest), About{"N m", "largest brake torque that it applies", kNonNegative}.usually(0, 1e5));
        field(TREAD_FIELD(lowest_speed),
              About{"m/s", "speed below which it does not intervene", kPositive}.usually(0.1, 30));
    }
};
static_assert(describesEveryMember<StabilityControlParams>());

// Share of its intervention that reaches the brakes; 0: it does not act.
inline double authority(const StabilityControlParams& params) {
    return std::clamp((params.enabled ? 1.0 : 0.0) + params.authority_offset, 0.0, 1.0);
}

struct StabilityControlState {
    double target = 0;        // rad/s, steady yaw rate that the driver asks for
    double reference = 0;     // rad/s, that with its lag
    double since_sample = 1;  // s: the first step samples
    PerWheel<double> torque;  // N m, asked of each brake
};

// All at the end of the step.
struct StabilityControlInput {
    double speed;      // m/s, forward
    double steer;      // rad, mean of the front wheels
    double yaw_rate;   // rad/s
    double wheelbase;  // m
};

// Brake torque that it asks of each wheel.
TREAD_API PerWheel<double> advance(StabilityControlState& state, const StabilityControlParams& params,
                                   const StabilityControlInput& input, double dt);

}  // namespace tread
