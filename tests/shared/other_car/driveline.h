// Engine and driven front wheels of the other car, in one fixed gear.
#pragma once

#include <algorithm>
#include <cmath>

#include "shared/other_car/controls.h"
#include "shared/other_car/forces.h"
#include "shared/other_car/params.h"
#include "shared/other_car/road_and_air.h"

namespace other_car {

inline double engineSpeed(const Params& p, const Vector& s) {  // rad/s
    return 0.5 * p.drive_ratio * (s[kSpin] + s[kSpin + 1]);
}

inline double engineTorque(const Params& p, const Vector& s, const Input& input) {  // N m
    const double waiting = p.structure.turbo_lag ? std::max(0.0, input.throttle - s[kBoost]) : 0;
    return (input.throttle - kTurboShare * waiting) * p.drive_scale * valueAt(p.drive_full, engineSpeed(p, s)) -
           (1 - input.throttle) * p.drag_scale * valueAt(p.drive_drag, engineSpeed(p, s));
}

// Throttle that holds the speed in a straight line on a level road in still air.
inline double holdingThrottle(const Params& p, const Vector& s) {
    const double v = s[kVx], engine = p.drive_ratio * s[kSpin];
    const double rolling = p.mass * kGravity * p.front.tyre.rolling_resistance;
    const double need = (rolling + 0.5 * p.air_density * p.drag_area * v * v) * p.front.tyre.loaded_radius;
    const double drag = p.drag_scale * valueAt(p.drive_drag, engine);
    const double full = p.drive_scale * valueAt(p.drive_full, engine);
    return (need / (p.drive_ratio * p.drive_efficiency) + drag) / (full + drag);
}

// Angular acceleration of wheel i, rad/s2. `tyre`: its own.
inline double spinRate(const Params& p, const Tyre& tyre, std::size_t i, const Vector& s, const Input& input,
                       const Forces& f) {
    double drive = 0, inertia = (i < 2 ? p.front : p.rear).wheel_inertia;
    if (i < 2) {
        const double other = s[kSpin + 1 - i] - s[kSpin + i];
        drive = 0.5 * engineTorque(p, s, input) * p.drive_ratio * p.drive_efficiency +
                (p.structure.viscous_differential ? kViscousTorque * other : 0);
        inertia += 0.5 * p.engine_inertia * p.drive_ratio * p.drive_ratio;
    }
    const double brake = (0.5 * brakeTorque(p, i < 2, s, input) + p.wheels[i].drag_torque) * std::tanh(s[kSpin + i]);
    const double faster = p.structure.rolling_resistance_by_speed ? std::pow(s[kVx] / kRollingSpeed, 2) / 2 : 0;
    const double rolling = tyre.rolling_resistance * (1 + faster) * f.load[i] * tyre.rolling_radius;
    return (drive - brake - rolling - f.fx[i] * tyre.loaded_radius) / inertia;
}

}  // namespace other_car
