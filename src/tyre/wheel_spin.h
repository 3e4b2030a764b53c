// The spin of a wheel as one more unknown of a stage, with a Coulomb brake that can lock it.
// T is double, or Lanes for four wheels at once.
#pragma once

#include "tyre/patch_stage.h"

namespace tread {
inline namespace TREAD_ISA {

// The spin at the end of a stage, I dOmega/dt = torque - radius Fx, with Fx = kFx du + cFx u (21): affine in du.
template <class T>
struct SpinStage {
    const BasicTyreSpin<T>& wheel;
    T base;         // Omega from which the stage starts
    T torque_free;  // drive and rolling resistance
    T Re;

    Affine<T> omega(const Stage<T>& s, const T& brake_torque) const {
        const T rate = s.step / wheel.inertia;
        return {base + rate * (torque_free + brake_torque - wheel.radius * s.p.cFx * s.base.u),
                -rate * wheel.radius * (s.kFx + s.step * s.p.cFx)};
    }
};

template <class T>
struct Solution {
    Patch<T> patch;
    T Omega;
};

template <class T>
Solution<T> solveSliding(Stage<T>& s, const SpinStage<T>& spin, const T& Vx, const T& brake_torque,
                         const PatchVelocity<T>& guess) {
    const Affine<T> omega = spin.omega(s, brake_torque);
    s.Vsx = {Vx - spin.Re * omega.value, -spin.Re * omega.slope};
    const Patch<T> patch = solve(s, guess);
    return {patch, omega.at(patch.velocity.du)};
}

// Coulomb brake: the wheel stays locked while the torque that this needs is within the brake's capacity; else the brake
// opposes the spin.
template <class T>
Solution<T> solveSpin(Stage<T>& s, const SpinStage<T>& spin, const T& Vx, const PatchVelocity<T>& guess) {
    const T& capacity = spin.wheel.brake_torque;
    const auto free = capacity <= T(0);
    if (all(free)) return solveSliding(s, spin, Vx, T(0), guess);

    // A wheel that turns, and still turns the same way at the end.
    const auto turning = spin.base != T(0);
    const auto may_roll = free | turning;
    const T against = select(turning, T(-withSign(capacity, spin.base)), T(0));
    Solution<T> solution;
    auto rolls = may_roll;
    if (any(may_roll)) {
        solution = solveSliding(s, spin, Vx, select(free, T(0), against), guess);
        rolls = free | (turning & (solution.Omega * withSign(T(1), spin.base) > T(0)));
        if (all(rolls)) return solution;
    }

    // A wheel that the brake can hold.
    s.Vsx = {Vx, 0};
    const Patch<T> locked = solve(s, guess);
    const T needed = -spin.omega(s, T(0)).at(locked.velocity.du) * spin.wheel.inertia / s.step;
    const auto holds = (!rolls) & (magnitude(needed) <= capacity);
    if (any(holds)) solution = select(holds, Solution<T>{locked, 0}, solution);
    if (all(rolls | holds)) return solution;

    // One that turns over.
    const Solution<T> turned = solveSliding(s, spin, Vx, withSign(capacity, needed), guess);
    return select(rolls | holds, solution, turned);
}

}  // namespace TREAD_ISA
}  // namespace tread
