#include "tread/aero.h"

namespace tread {

AeroForces forces(const AeroParams& params, const Vector3& air_velocity_B) {
    const double speed = air_velocity_B.norm();
    const double half_density = 0.5 * params.air_density;
    const double forward_pressure = half_density * air_velocity_B.x() * air_velocity_B.x();
    return {.drag_B = -half_density * params.drag_area * speed * air_velocity_B,
            .front_lift = forward_pressure * params.front_lift_area,
            .rear_lift = forward_pressure * params.rear_lift_area};
}

}  // namespace tread
