// The tyre of the other car: the similarity method (H.B. Pacejka, Tyre and Vehicle Dynamics, 2nd ed. 2006, chapter 4).
// One Magic Formula for the vector of both slips, camber as a shift of the slip angle, pneumatic trail of the brush
// model. structure.h has alternatives for its shape and for combined slip.
#pragma once

#include <algorithm>
#include <cmath>

#include "shared/other_car/structure.h"

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
    double rolling_radius = 0.3055;     // m, at the nominal load
    double rolling_radius_by_load = 0;  // relative change over relative load
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

inline double rollingRadius(const Tyre& tyre, double load) {
    return tyre.rolling_radius * (1 + tyre.rolling_radius_by_load * (load / tyre.nominal_load - 1));
}

// Force over friction force. `slip`: linear force (stiffness times slip) over friction force.
inline double usedShare(const Tyre& tyre, const Structure& structure, double slip) {
    if (structure.hyperbolic_tyre) return std::tanh(slip);
    if (structure.brush_tyre) {
        const double s = std::clamp(slip / 3, -1.0, 1.0);  // over the slip at which the whole contact slides
        return s * (3 - 3 * std::abs(s) + s * s);
    }
    const double x = slip / tyre.shape;
    return std::sin(tyre.shape * std::atan(x - tyre.curvature * (x - std::atan(x))));
}

// Brush model: trail over its value without slip. `used`: force over friction force.
inline double trailShare(double used) {
    const double stuck = std::cbrt(std::max(0.0, 1 - std::abs(used))), slid = 1 - stuck;
    return stuck * stuck * stuck / (1 - slid + slid * slid / 3);
}

// `alpha` is positive for a force to the left, `camber` for a top that leans to the right.
inline TyreForce force(const Tyre& tyre, const Structure& structure, double load, double road_friction, double kappa,
                       double alpha, double camber) {
    if (load <= 0) return {0, 0, 0};
    const double relative = (load - tyre.nominal_load) / tyre.nominal_load;
    const double peak = load * road_friction * tyre.friction * (1 + tyre.friction_by_load * relative);
    const double stiffness = corneringStiffness(tyre, load);
    const double along = slipStiffness(tyre, load) * kappa / peak;
    const double across = (stiffness * std::tan(alpha) - tyre.camber_stiffness * load * camber) / peak;
    const double trail = tyre.trail * load / tyre.nominal_load;
    if (structure.friction_ellipse) {
        const double fx = usedShare(tyre, structure, along), side = usedShare(tyre, structure, across);
        const double left = std::sqrt(std::max(0.0, 1 - fx * fx));
        return {peak * fx, peak * side * left, trail * trailShare(std::hypot(fx, side * left))};
    }
    const double slip = std::hypot(along, across);
    if (slip < 1e-9) return {peak * along, peak * across, trail};
    const double used = usedShare(tyre, structure, slip);
    return {peak * used * along / slip, peak * used * across / slip, trail * trailShare(used)};
}

}  // namespace other_car
