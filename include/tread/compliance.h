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

#include "tread/lag.h"

namespace tread {

inline constexpr double kYieldingTime = 0.01;  // s

struct AligningCompliance {
    double deflection = 0;  // rad
    double rate = 0;        // rad/s, over the last step
    double moment = 0;      // N m, at the beginning of the last step, without what the resistance took from it

    // Deflection at the end of a step; `now` is the moment at its beginning, extrapolated from there (steps are equal);
    // `stiffness`, in N m/rad, is about that by which the moment falls with the deflection, `resistance`, in N m s/rad,
    // at least about that by which it falls at once with its rate. Exact for such a moment.
    double advance(double compliance, double stiffness, double resistance, double now, double dt) {
        const double unresisted = now + resistance * rate;
        const double change = unresisted - moment;
        moment = unresisted;
        const double time_constant = compliance * (stiffness * kYieldingTime + resistance);
        const double begin = compliance * unresisted, end = compliance * (unresisted + change);
        const double before = deflection;
        deflection = lagged(before, begin, end, time_constant, dt);
        rate = (deflection - before) / dt;
        return deflection;
    }
};

}  // namespace tread
