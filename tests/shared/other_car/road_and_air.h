// Sloping road and wind around the other car.
#pragma once

#include <array>
#include <cmath>

#include "shared/other_car/forces.h"
#include "shared/other_car/params.h"

namespace other_car {

inline constexpr double kGravity = 9.80665;  // m/s2

// Slope of the road along and across the car, rise over run.
struct Slope {
    double x, y;
};
inline Slope slope(const Params& p, const Vector& s) {
    const double c = std::cos(s[kYaw]), n = std::sin(s[kYaw]);
    return {c * p.grade + n * p.bank, -n * p.grade + c * p.bank};
}

// Velocity of the air relative to the car, in its axes, m/s.
inline std::array<double, 2> air(const Params& p, const Vector& s) {
    const double c = std::cos(s[kYaw]), n = std::sin(s[kYaw]);
    return {c * p.wind_x + n * p.wind_y - s[kVx], -n * p.wind_x + c * p.wind_y - s[kVy]};
}

inline double dynamicPressure(const Params& p, const Vector& s) {  // N/m2
    const auto [x, y] = air(p, s);
    return 0.5 * p.air_density * (x * x + y * y);
}

inline PlaneForce airForce(const Params& p, const Vector& s) {
    const auto [x, y] = air(p, s);
    const double pressure = 0.5 * p.air_density * std::hypot(x, y);  // over the speed of the air
    const double sideslip = std::atan2(y, -x), square = pressure * std::hypot(x, y);
    const double aside = pressure * p.drag_area * y + square * p.side_area * sideslip;
    const double middle = p.front_distance - 0.5 * p.wheelbase;  // of the wheelbase, ahead of the centre of gravity
    return {pressure * p.drag_area * x, aside, square * p.yaw_volume * sideslip + aside * middle};
}

}  // namespace other_car
