// Aerodynamics: drag and lift on the body.
#pragma once

#include "tread/describe.h"
#include "tread/vector.h"

namespace tread {

struct AeroParams {
    double air_density = 1.2041;
    double drag_area = 0;
    double front_lift_area = 0;
    double rear_lift_area = 0;
    double height = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(air_density),
              About{"kg/m3", "density of the air (default: 20 degC, 1013 hPa)", kNonNegative, 0.03});
        field(TREAD_FIELD(drag_area), About{"m2", "drag coefficient times frontal area", kNonNegative, 0.05});
        field(TREAD_FIELD(front_lift_area),
              About{"m2", "lift coefficient of the front axle times frontal area, positive up"});
        field(TREAD_FIELD(rear_lift_area),
              About{"m2", "lift coefficient of the rear axle times frontal area, positive up"});
        field(TREAD_FIELD(height), About{"m", "height above the road where the drag acts", kNonNegative});
    }
};
static_assert(describesEveryMember<AeroParams>());

struct AeroForces {
    Vector3 drag_B;     // N, at `height` above the road
    double front_lift;  // N, at the front axle
    double rear_lift;   // N, at the rear axle
};

// Forces at the velocity of the body through the air, in body axes.
AeroForces forces(const AeroParams& params, const Vector3& air_velocity_B);

}  // namespace tread
