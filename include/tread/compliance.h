// A part that yields to the aligning moment of tyres, which in turn falls as it yields.
//
// Taken at once, deflection = compliance * moment is an algebraic loop through the tyre, and one that is taken a step
// late swings. Real parts have inertia and damping: here a damping of the aligning stiffness times kYieldingTime, so
// that the deflection follows with a time constant of compliance * stiffness * kYieldingTime: a few milliseconds for a
// car, less than the tyre's own, none for a rigid part. What the parts come to is the compliance's alone.
#pragma once

#include <cmath>

namespace tread {

inline constexpr double kYieldingTime = 0.01;  // s

struct AligningCompliance {
    double deflection = 0;  // rad
    double moment = 0;      // N m, at the beginning of the last step

    // Deflection at the end of a step; `now` is the moment at its beginning, extrapolated from there (steps are equal);
    // `stiffness`, in N m/rad, is about that by which the moment falls with the deflection. Exact for such a moment.
    double advance(double compliance, double stiffness, double now, double dt) {
        const double change = now - moment;
        moment = now;
        const double time_constant = compliance * stiffness * kYieldingTime;
        const double begin = compliance * now, end = compliance * (now + change);
        if (time_constant == 0) return deflection = end;
        const double behind = time_constant * (end - begin) / dt;
        return deflection = end - behind + (deflection - begin + behind) * std::exp(-dt / time_constant);
    }
};

}  // namespace tread
