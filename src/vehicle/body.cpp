#include "vehicle/body.h"

namespace tread {

AirPush airPush(const VehicleParams& params, const std::array<double, 3>& air_velocity_B) {
    const AeroForces air = forces(params.aero, toVector(air_velocity_B));
    Wrench wrench;
    const double centre = -params.lateral_offset;
    wrench.add(air.drag_B, {0, centre, params.aero.height - params.centre_of_gravity_height});
    wrench.add({0, 0, air.front_lift}, {params.front_axle_distance, centre, 0});
    wrench.add({0, 0, air.rear_lift}, {params.front_axle_distance - params.wheelbase, centre, 0});
    const double middle = params.front_axle_distance - 0.5 * params.wheelbase;
    wrench.add({0, air.side_force, 0}, {middle, 0, params.aero.height - params.centre_of_gravity_height});
    wrench.moment_B += Vector3(air.roll_moment, 0, air.yaw_moment);
    return {toArray(wrench.force_B), toArray(wrench.moment_B)};
}

}  // namespace tread
