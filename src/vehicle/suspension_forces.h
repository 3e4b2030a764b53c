// The formulas of suspension.h. T is double, or lanes of which each holds another car: then the parameters are those of
// LaneSuspension (lane_cars.h), which have no curves.
#pragma once

#include "base/math/elementary.h"
#include "tread/suspension.h"

namespace tread {

// A value over something, with its slope.
template <class T>
struct Line {
    T value;
    T slope;
};
// A curve of two points or more, continued beyond its ends with their slopes.
Line<double> along(const Curve& curve, double x);

// Dry friction builds up over this speed: small enough to be dry, large enough for the implicit wheel equation.
inline constexpr double kDamperFrictionSpeed = 0.005;  // m/s

inline namespace TREAD_ISA {

// Force of a stop that is compressed by `deflection`.
template <class T>
Line<T> push(const BasicStopParams<T>& stop, const T& deflection) {
    const auto open = deflection <= T(0);
    return {select(open, T(0), T((stop.stiffness + stop.progression * deflection) * deflection)),
            select(open, T(0), T(stop.stiffness + 2 * stop.progression * deflection))};
}

template <class T, class Params>
Line<T> springForce(const Params& params, const T& travel) {
    if constexpr (requires { params.spring_curve; }) {
        if (!params.spring_curve.empty()) return along(params.spring_curve, travel);
    }
    return {params.spring * travel, params.spring};
}

template <class T, class Params>
Line<T> damperForce(const Params& damper, const T& rate) {
    const auto bump = rate > T(0);
    if constexpr (requires { damper.bump_curve; }) {
        const Curve& curve = bump ? damper.bump_curve : damper.rebound_curve;
        if (!curve.empty()) {
            const Line<T> line = along(curve, bump ? rate : -rate);
            return {bump ? line.value : -line.value, line.slope};
        }
    }
    const T damping = select(bump, damper.bump, damper.rebound);
    return {damping * rate, damping};
}

template <class T>
Line<T> dryFriction(const T& friction, const T& rate) {
    const auto rubs = friction != T(0);
    if (!any(rubs)) return {0, 0};
    const T slide = hyperbolicTangent(T(rate / kDamperFrictionSpeed));
    return {select(rubs, T(friction * slide), T(0)),
            select(rubs, T(friction / kDamperFrictionSpeed * (1.0 - slide * slide)), T(0))};
}

template <class T, class Params>
BasicSuspensionForce<T> suspensionForces(const Params& params, const BasicSuspensionInput<T>& input) {
    // Spring: carries the static load at zero travel, and cannot pull.
    const Line<T> extra = springForce(params, input.travel);
    const T spring = input.static_force + extra.value;
    const auto pushes = spring > T(0);
    BasicSuspensionForce<T> total{select(pushes, spring, T(0)), select(pushes, extra.slope, T(0)), 0};

    // Damper and dry friction.
    const Line<T> damper = damperForce(params.damper, input.rate);
    const Line<T> friction = dryFriction(params.damper.friction, input.rate);
    total.force += damper.value + friction.value;
    total.by_rate += damper.slope + friction.slope;

    // Anti-roll bar.
    total.force += params.anti_roll_bar * (input.travel - input.opposite_travel);
    total.by_travel += params.anti_roll_bar;

    // Stops.
    const Line<T> bump = push(params.bump_stop, T(input.travel - params.bump_stop.clearance));
    const Line<T> rebound = push(params.rebound_stop, T(-input.travel - params.rebound_stop.clearance));
    total.force += bump.value - rebound.value;
    total.by_travel += bump.slope + rebound.slope;
    return total;
}

template <class T, class Params>
BasicWheelAngles<T> suspensionAngles(const Params& params, const T& travel, bool left) {
    const double outwards = left ? -1 : 1;
    return {.camber = outwards * (params.camber + params.camber_by_travel * travel),
            .toe = outwards * (params.toe + params.toe_by_travel * travel)};
}

template <class T, class Params>
BasicWheelAngles<T> suspensionCompliance(const Params& params, const T& fx, const T& fy, bool left) {
    // A force to the left pulls the contact to the left: the top leans to the right.
    const double outwards = left ? -1 : 1;
    return {.camber = params.camber_by_lateral_force * fy,
            .toe = params.steer_by_lateral_force * fy + outwards * params.steer_by_longitudinal_force * fx};
}

}  // namespace TREAD_ISA
}  // namespace tread
