// Brakes: from the pedal to the torque that each wheel's brake can hold.
#pragma once

#include "tread/describe.h"
#include "tread/wheels.h"

namespace tread {

struct BrakeParams {
    double full_pedal_torque = kRequired;
    double front_share = kRequired;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(full_pedal_torque),
              About{"N m", "brake torque of all four wheels together at full pedal", kNonNegative, 0.1});
        field(TREAD_FIELD(front_share), About{"-", "share of the front axle (brake balance)", kFraction, 0.05});
    }
};
static_assert(describesEveryMember<BrakeParams>());

// Torque that the brake of one wheel of each axle holds or drags with, N m, not negative.
PerAxle<double> brakeTorques(const BrakeParams& params, double pedal);

}  // namespace tread
