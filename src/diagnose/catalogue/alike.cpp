// Effects that can imitate each other: in many drives their signatures are alike, so that the wrong one of them may be
// named. Each comment says what they have in common.

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "diagnose/catalogue/catalogue.h"

namespace tread::diagnose::catalogue {
namespace {

using Family = std::initializer_list<std::string_view>;

// Of each family, every two are alike.
const std::initializer_list<Family>& families() {
    static const std::initializer_list<Family> all{
        // Understeer by a smaller steer angle or a weaker front axle.
        {"steering_ratio", "cornering_stiffness_front", "compliance_steer_front", "steering_compliance"},
        {"compliance_steer_front", "roll_steer_front"},
        {"steering_compliance", "pneumatic_trail"},
        // Sideslip of the rear axle per side force.
        {"cornering_stiffness_rear", "compliance_steer_rear", "roll_steer_rear"},
        // Whole tyres and their parts.
        {"another_tyre", "grip", "tyre_curvature"},
        {"another_tyre", "cornering_stiffness_front"},
        {"another_tyre", "cornering_stiffness_rear"},
        {"another_tyre", "load_sensitivity"},
        {"another_tyre", "slip_stiffness"},
        {"another_tyre", "tyre_pressure"},
        {"another_tyre", "tyre_temperature"},
        {"tyre_front_left", "tyre_front_right", "cornering_stiffness_front"},
        {"tyre_rear_left", "tyre_rear_right", "cornering_stiffness_rear"},
        {"tyre_front_left", "tyre_rear_left", "grip_left_right"},
        {"tyre_front_right", "tyre_rear_right", "grip_left_right"},
        {"camber_thrust", "camber_gain"},
        // Late reaction.
        {"steering_delay", "sensor_delay", "tyre_relaxation"},
        {"yaw_inertia", "tyre_relaxation"},
        {"speed_delay", "brake_delay"},
        {"speed_delay", "drive_response"},
        // Mass and where it is.
        {"load", "mass", "fuel"},
        {"load", "cg_fore_aft", "accelerometer_position"},
        {"load", "roof_load", "cg_height"},
        {"roof_load", "roll_inertia"},
        {"mass", "drive_gain"},
        {"mass", "brake_gain"},
        {"brake_gain", "brake_fade"},
        // Roll.
        {"cg_height", "roll_stiffness", "spring_rate"},
        {"roll_stiffness_distribution", "roll_centre_height", "load_sensitivity"},
        {"dampers", "suspension_friction"},
        // Resistance on a straight.
        {"aero_drag", "rolling_resistance", "engine_braking", "grade"},
        {"aero_drag", "wind"},
        {"grade", "accelerometer_bias"},
        // The same on one side of the car.
        {"brake_drag_front_left", "brake_drag_rear_left"},
        {"brake_drag_front_right", "brake_drag_rear_right"},
        // Pull to one side.
        {"steering_zero", "bank", "conicity", "ply_steer", "load_offset"},
        {"bank", "accelerometer_bias"},
        {"bank", "wind"},
        {"steering_zero", "gyro_bias"},
        {"toe_rear", "sideslip_zero"},
        // Speed against wheel speed.
        {"wheel_radius", "wheel_speed_scale", "speed_scale"},
        // The body rolls in proportion to the lateral acceleration.
        {"accelerometer_gravity", "accelerometer_scale"},
    };
    return all;
}

}  // namespace

std::vector<std::string> alikeTo(std::string_view name) {
    std::vector<std::string> names;
    for (const Family& family : families()) {
        if (std::find(family.begin(), family.end(), name) == family.end()) continue;
        for (const std::string_view other : family) {
            if (other != name && std::find(names.begin(), names.end(), other) == names.end()) names.emplace_back(other);
        }
    }
    return names;
}

}  // namespace tread::diagnose::catalogue
