// Steering: from the hand wheel to the two front wheels.
#pragma once

#include "tread/describe.h"

namespace tread {

struct SteeringParams {
    double ratio = kRequired;
    double ackermann = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(ratio), About{"-", "hand-wheel angle over mean road-wheel angle", kPositive, 0.02});
        field(TREAD_FIELD(ackermann),
              About{"-", "0: wheels parallel, 1: both wheels tangent to circles about the rear axle's extension"});
    }
};
static_assert(describesEveryMember<SteeringParams>());

struct RoadWheelAngles {
    double left;   // rad, positive to the left
    double right;  // rad
};

// Road-wheel angles at a hand-wheel angle, without toe. Track and wheelbase in m.
RoadWheelAngles roadWheelAngles(const SteeringParams& params, double steering_wheel_angle, double track,
                                double wheelbase);

}  // namespace tread
