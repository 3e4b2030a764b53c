#include "tread/aero.h"

#include <cmath>

#include "base/math/elementary.h"

namespace tread {

AeroForces forces(const AeroParams& params, const Vector3& air_velocity_B) {
    const double speed = air_velocity_B.norm();
    const double half_density = 0.5 * params.air_density;
    const double forward_pressure = half_density * air_velocity_B.x() * air_velocity_B.x();
    AeroForces air{.drag_B = -half_density * params.drag_area * speed * air_velocity_B,
                   .front_lift = forward_pressure * params.front_lift_area,
                   .rear_lift = forward_pressure * params.rear_lift_area,
                   .side_force = 0,
                   .yaw_moment = 0,
                   .roll_moment = 0};
    if (params.side_force_area.empty() && params.yaw_moment_volume.empty() && params.roll_moment_volume.empty())
        return air;

    // A body that moves to the left through the air is pushed to the right; the nose turns to the right, away from the
    // wind; and the roof leans to the right.
    const double sideslip = arctan2(air_velocity_B.y(), air_velocity_B.x());
    const double angle = std::abs(sideslip);
    const double pressure = half_density * air_velocity_B.head<2>().squaredNorm();
    const double against = std::copysign(pressure, -sideslip);
    air.side_force = against * params.side_force_area(angle);
    air.yaw_moment = against * params.yaw_moment_volume(angle);
    air.roll_moment = -against * params.roll_moment_volume(angle);
    return air;
}

}  // namespace tread
