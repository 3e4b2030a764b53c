// The numbers of the other car.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "shared/other_car/tyre.h"

namespace other_car {

struct Axle {
    Tyre tyre;
    double track = 1.5;
    double spring = 0, anti_roll_bar = 0;  // N/m, at the wheel; per difference of the wheel travels
    double damping = 0;                    // N s/m, at the wheel
    double brake_support = 0;              // vertical force of the links over the braking force (anti-dive, anti-lift)
    double roll_axis = 0.08;               // m, height above the road
    double unsprung_mass = 0;              // kg, per wheel
    double wheel_inertia = 1;              // kg m2, per wheel
    double compliance_steer = 0;           // rad/N, per lateral force of the wheel
    double toe = 0, toe_by_travel = 0;     // rad, at rest, and rad/m, toe-in
    double camber = 0;                     // rad, at rest, positive: top outwards
    double camber_by_travel = 0;           // rad/m
    double lift_area = 0;                  // m2

    double rollStiffness() const {  // N m/rad, of suspension and tyres in series
        const double wheel = spring + 2 * anti_roll_bar;
        return 0.5 * track * track * wheel * tyre.radial_stiffness / (wheel + tyre.radial_stiffness);
    }
    // Travel of the right wheel per roll angle, m/rad.
    double travelByRoll() const {
        return 0.5 * track * tyre.radial_stiffness / (spring + 2 * anti_roll_bar + tyre.radial_stiffness);
    }
    // Travel of both wheels over that of the body above the axle.
    double travelByDive() const { return tyre.radial_stiffness / (spring + tyre.radial_stiffness); }
    double pitchRate() const {  // N/m at the axle
        return 2 * spring * tyre.radial_stiffness / (spring + tyre.radial_stiffness);
    }
    double pitchDamping() const {  // N s/m at the axle
        const double suspension = tyre.radial_stiffness / (spring + tyre.radial_stiffness);
        return 2 * damping * suspension * suspension;
    }
    double rollDamping() const {  // N m s/rad, of the share of the roll angle that the suspension takes
        const double suspension = tyre.radial_stiffness / (spring + 2 * anti_roll_bar + tyre.radial_stiffness);
        return 0.5 * track * track * damping * suspension * suspension;
    }
};

// Faults of one wheel; neutral by default.
struct WheelFault {
    double stiffness = 1, slip_stiffness = 1, friction = 1;  // factors of the values of the tyre
    double drag_torque = 0;                                  // N m, of a dragging brake
};

using Line = std::vector<std::array<double, 2>>;  // piecewise linear, {x, y}

struct Params {
    double mass = 1350, yaw_inertia = 1950, roll_inertia = 480, pitch_inertia = 1750;
    double front_distance = 1.03, wheelbase = 2.62, height = 0.54;
    Axle front, rear;
    Structure structure;
    std::array<WheelFault, 4> wheels;
    double steering_ratio = 16.5;
    double ratio_curvature = 0;  // 1/rad2, relative change of the ratio per squared steering-wheel angle
    double steering_lag = 0;     // s
    double brake_torque = 5000, brake_front_share = 0.82;
    double brake_lag = 0;              // s
    double drive_ratio = 0.78 * 3.94;  // one gear
    double engine_inertia = 0.148;     // kg m2
    Line drive_full, drive_drag;       // N m over rad/s, of the engine
    double drive_scale = 1, drag_scale = 1;
    double drive_efficiency = 0.94;
    double drag_area = 0.66, air_density = 1.2041;
    double side_area = 0, yaw_volume = 0;  // m2/rad, m3/rad (at mid-wheelbase), per sideslip angle of the air
    double wind_x = 0, wind_y = 0;         // m/s, velocity of the air
    double grade = 0, bank = 0;            // rise over run along x and y
    double road_friction = 1;
};

inline double valueAt(const Line& line, double x) {
    std::size_t i = 1;
    while (i + 1 < line.size() && line[i][0] < x) ++i;
    const auto &a = line[i - 1], &b = line[i];
    const double share = std::clamp((x - a[0]) / (b[0] - a[0]), 0.0, 1.0);
    return a[1] + share * (b[1] - a[1]);
}

}  // namespace other_car
