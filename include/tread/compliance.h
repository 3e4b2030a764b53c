// A part that yields to the aligning moment of tyres, which falls as it yields.
//
// The deflection x = compliance * M(x) is an algebraic loop through the tyre: taken one step late it swings, and grows
// when compliance times aligning stiffness is large. Here the moment is extrapolated, and corrected for the deflection
// that the extrapolation did not know of by an aligning stiffness that need only be about right: second order, stable
// while the stiffness given is not less than the tyre's.
#pragma once

namespace tread {

struct AligningCompliance {
    double deflection = 0;  // rad, at the end of the last step
    double before = 0;      // rad, at its beginning
    double moment = 0;      // N m, that moved it there

    // Deflection at the end of a step; `now` is the moment at its beginning, `stiffness` in N m/rad. Steps are equal.
    double advance(double compliance, double stiffness, double now) {
        const double predicted = 2 * deflection - before;
        const double extrapolated = 2 * now - moment;
        before = deflection;
        moment = now;
        deflection = compliance * (extrapolated + stiffness * predicted) / (1 + compliance * stiffness);
        return deflection;
    }
};

}  // namespace tread
