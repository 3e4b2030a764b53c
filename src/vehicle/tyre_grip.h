// What a tyre can hold along the road, and what it may not store beyond that.
#pragma once

#include "base/math/lanes.h"
#include "tread/tyre.h"

namespace tread {

// The most that a tyre can hold under a motion's load and camber, N: peak friction along or across, ply-steer and
// conicity included; `friction` scales it.
double gripOf(const TyreParams& tyre, const TyreMotion& motion, double friction);

// Lets go of what the carcass stores beyond the grip, and of the forces that come of it. For wheels without mass: an
// edge may take their load away within one step, and until the contact patch has swung back the tyre would push the rim
// by more than the road gives. A game is promised the circle of the grip, also for a tyre that holds more at combined
// slip than at pure slip. The whole car goes without: the load of a wheel with mass falls over steps in which the patch
// follows (some 700 rad/s), what its inertia adds is the paper's (17), (18), and a tyre of a measured car may hold a
// fifth more at combined slip.
void limitToGrip(TyreState& state, TyreForces& forces, const TyreCoefficients& p, double grip);

inline namespace TREAD_ISA {

// Power that the contact patch loses to the road, W, not negative: its force (ISO 8855 wheel axes) times its slip
// velocity, which is that of the rim and its own against the rim.
template <class T>
T slipPower(const BasicTyreMotion<T>& motion, const BasicTyreState<T>& state, const T& rolling_speed, const T& fx,
            const T& fy) {
    const T Vsx = motion.Vx - rolling_speed + state.du;
    const T Vsy = motion.Vsy + state.dv;
    return larger(T(-fx * Vsx + fy * Vsy), T(0));  // fy counts to the left, Vsy to the right
}

}  // namespace TREAD_ISA

}  // namespace tread
