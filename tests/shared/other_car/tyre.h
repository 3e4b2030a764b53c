// The tyre of the other car: the similarity method (H.B. Pacejka, Tyre and Vehicle Dynamics, 2nd ed. 2006, chapter 4).
// One magic formula for the slip as a vector, camber as a shift of the slip angle, the trail of the brush model.
#pragma once

#include <algorithm>
#include <cmath>

namespace other_car {

struct Tyre {
    double friction = 0.99;           // at the nominal load
    double friction_by_load = -0.15;  // relative change over relative load
    double stiffness = 59800;         // N/rad, largest cornering stiffness, reached at
    double stiffness_load = 8500;     // N
    double slip_stiffness = 21.5;     // longitudinal, over the load, at the nominal load
    double slip_stiffness_by_load = 0.24;
    double camber_stiffness = 1.39;  // 1/rad, camber thrust over the load
    double trail = 0.0313;           // m, without slip, at the nominal load
    double nominal_load = 4000;      // N
    double shape = 1.19;
    double curvature = -1;
    double carcass = 141800;    // N/m, lateral
    double carcass_x = 474500;  // N/m
    double rolling_resistance = 0.0102;
    double rolling_radius = 0.3055;
    double loaded_radius = 0.294;
    double radial_stiffness = 183600;  // N/m
};

struct TyreForce {
    double fx, fy, trail;
};

inline double slipStiffness(const Tyre& tyre, double load) {
    return tyre.slip_stiffness * load * (1 + tyre.slip_stiffness_by_load * (load / tyre.nominal_load - 1));
}

inline double corneringStiffness(const Tyre& tyre, double load) {
    return tyre.stiffness * std::sin(2 * std::atan(load / tyre.stiffness_load));
}

// Lateral slip positive for a force to the left, camber for a top that leans to the right.
inline TyreForce force(const Tyre& tyre, double load, double road_friction, double kappa, double alpha, double camber) {
    if (load <= 0) return {0, 0, 0};
    const double relative = (load - tyre.nominal_load) / tyre.nominal_load;
    const double peak = load * road_friction * tyre.friction * (1 + tyre.friction_by_load * relative);
    const double stiffness = corneringStiffness(tyre, load);
    const double along = slipStiffness(tyre, load) / stiffness * kappa;
    const double across = std::tan(alpha) - tyre.camber_stiffness * load / stiffness * camber;
    const double slip = std::hypot(along, across), trail = tyre.trail * load / tyre.nominal_load;
    if (slip < 1e-9) return {stiffness * along, stiffness * across, trail};
    const double x = stiffness * slip / (tyre.shape * peak);
    const double used = std::sin(tyre.shape * std::atan(x - tyre.curvature * (x - std::atan(x))));
    // Brush model: the part of the contact that does not slide.
    const double stuck = std::cbrt(std::max(0.0, 1 - std::abs(used))), slid = 1 - stuck;
    const double shorter = stuck * stuck * stuck / (1 - slid + slid * slid / 3);
    return {peak * used * along / slip, peak * used * across / slip, trail * shorter};
}

}  // namespace other_car
