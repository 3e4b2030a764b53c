// What a snapshot of a RaycastVehicle holds.
#pragma once

#include <array>
#include <type_traits>

#include "tread/raycast_vehicle.h"
#include "vehicle/wheeled_body_state.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

struct RaycastSnapshot::State {
    WheeledBodyState car;
    std::array<WheelDemand, kMostWheels> demands;  // at the end of the last step
    std::array<double, 6> velocity{};              // linear and angular, at the instant of the last step
    std::array<double, 6> expected{};              // what the chassis shows if nobody else pushes it
    double planned = 0;                            // s, length of the step for which that was planned
    std::array<double, 12> pose{};                 // of the chassis: basis by rows, origin
    std::array<double, 6> body_velocity{};
    double deactivation_time = 0;
    int activation_state = 0;
    int wheel_count = 0;
    bool asleep = false;

    bool operator==(const State&) const = default;
};
static_assert(std::is_trivially_copyable_v<RaycastSnapshot::State>);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
