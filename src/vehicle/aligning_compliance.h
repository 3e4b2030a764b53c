// A part that yields to the aligning moment of tyres, which in turn falls as it yields.
//
// Taken at once, deflection = compliance * moment is an algebraic loop through the tyre, and one that is taken a step
// late swings. Real parts have inertia and damping: here a damping of the aligning stiffness times kYieldingTime, so
// that the deflection follows with a time constant of compliance * stiffness * kYieldingTime: a few milliseconds for a
// car, less than the tyre's own, none for a rigid part. What the parts come to is the compliance's alone.
//
// A tyre that rolls fast resists being turned more than that damping does: its belt is a gyroscope. This part of the
// moment answers within the step, and is taken at its end.
#pragma once

#include "base/math/lag.h"
#include "tread/state_parts.h"

namespace tread {

inline constexpr double kYieldingTime = 0.01;  // s

// What the part yields to.
struct AligningLoad {
    double moment;      // N m, at the beginning of the step; extrapolated from there (steps are equal)
    double stiffness;   // N m/rad, about that by which the moment falls with the deflection
    double resistance;  // N m s/rad, at least about that by which it falls at once with its rate
};

// Deflection at the end of the step, rad. Exact for a moment that falls as the load says.
[[gnu::always_inline]] inline double advance(AligningCompliance& part, double compliance, const AligningLoad& load,
                                             double dt) {
    const double unresisted = load.moment + load.resistance * part.rate;
    const double change = unresisted - part.moment;
    part.moment = unresisted;
    const double time_constant = compliance * (load.stiffness * kYieldingTime + load.resistance);
    const double begin = compliance * unresisted, end = compliance * (unresisted + change);
    const double before = part.deflection;
    part.deflection = lagged(before, begin, end, time_constant, dt);
    part.rate = (part.deflection - before) / dt;
    return part.deflection;
}

}  // namespace tread
