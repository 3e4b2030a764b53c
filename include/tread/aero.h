// Aerodynamics: forces and moments of the air on the body.
#pragma once

#include "tread/api.h"
#include "tread/curve.h"
#include "tread/describe.h"
#include "tread/vector.h"

namespace tread {

struct AeroParams {
    double air_density = 1.2041;
    double drag_area = 0;
    double front_lift_area = 0;
    double rear_lift_area = 0;
    double height = 0;
    Curve side_force_area{};
    Curve yaw_moment_volume{};
    Curve roll_moment_volume{};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(air_density),
              About{"kg/m3", "density of the air (default: 20 degC, 1013 hPa)", kNonNegative, 0.03}.usually(0.5, 1.6));
        field(TREAD_FIELD(drag_area),
              About{"m2", "drag coefficient times frontal area", kNonNegative, 0.05}.usually(0.001, 15));
        field(TREAD_FIELD(front_lift_area),
              About{"m2", "lift coefficient of the front axle times frontal area, positive up", kAny, 0.2}.usually(-10,
                                                                                                                   10));
        field(TREAD_FIELD(rear_lift_area),
              About{"m2", "lift coefficient of the rear axle times frontal area, positive up", kAny, 0.2}.usually(-10,
                                                                                                                  10));
        field(TREAD_FIELD(height),
              About{"m", "height above the road where drag and side force act", kNonNegative}.usually(0.005, 4));
        field(
            TREAD_FIELD(side_force_area),
            About{"m2",
                  "side force over dynamic pressure, towards where the air goes, over aerodynamic sideslip from 0 up; "
                  "in addition to the drag, which acts along the air; odd",
                  kAny, 0.1, "rad"}
                .usually(-100, 100)
                .over(0, 3.2));
        field(TREAD_FIELD(yaw_moment_volume),
              About{"m3",
                    "yaw moment at mid-wheelbase over dynamic pressure, positive when it turns the nose away from the "
                    "wind, over aerodynamic sideslip; odd",
                    kAny, 0.2, "rad"}
                  .usually(-500, 500)
                  .over(0, 3.2));
        field(TREAD_FIELD(roll_moment_volume),
              About{"m3",
                    "roll moment in addition to that of the side force over dynamic pressure, positive when it leans "
                    "the roof away from the wind, over aerodynamic sideslip; odd",
                    kAny, 0.3, "rad"}
                  .usually(-200, 200)
                  .over(0, 3.2));
    }
};
static_assert(describesEveryMember<AeroParams>());

struct AeroForces {
    Vector3 drag_B;      // N, at `height` above the road
    double front_lift;   // N, at the front axle
    double rear_lift;    // N, at the rear axle
    double side_force;   // N, at mid-wheelbase and `height`, positive to the left
    double yaw_moment;   // N m, positive to the left
    double roll_moment;  // N m, positive to the right side down
};

// Forces at the velocity of the body through the air, in body axes. Aerodynamic sideslip is the angle between that
// velocity and the body's x axis in the x-y plane.
TREAD_API AeroForces forces(const AeroParams& params, const Vector3& air_velocity_B);

}  // namespace tread
