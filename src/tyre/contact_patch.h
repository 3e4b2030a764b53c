// The transient part of Delft Tyre 97: contact-patch mass on the carcass, gyroscopic effects of the belt, wheel spin.
// Equations (17)-(28) of Pacejka & Besselink (1997), integrated by the two-stage SDIRK method with
// gamma = 1 - 1/sqrt(2): second order, L-stable and stiffly accurate, which the slip damper (up to 8e6 1/s near
// standstill) and the contact mass (600 rad/s) ask for. T is double, or Lanes for four wheels at once.
#pragma once

#include <numbers>

#include "tyre/wheel_spin.h"

namespace tread {
inline namespace TREAD_ISA {

inline constexpr double kGamma = 1 - 1 / std::numbers::sqrt2;  // SDIRK2

template <class T>
struct TyreOf {
    const BasicTyreCoefficients<T>& p;
    const BasicTyreScaling<T>& l;
};

template <class T>
BasicTyreMotion<T> between(const BasicTyreMotion<T>& a, const BasicTyreMotion<T>& b, double share) {
    const auto mix = [share](const T& x, const T& y) { return T(x + share * (y - x)); };
    return {mix(a.Vsx, b.Vsx),       mix(a.Vsy, b.Vsy),     mix(a.Vx, b.Vx), mix(a.Omega, b.Omega),
            mix(a.psidot, b.psidot), mix(a.gamma, b.gamma), mix(a.Fz, b.Fz)};
}

// ---- Carcass and belt ----

template <class T>
T nonLaggingCamberForce(const BasicTyreCoefficients<T>& p, const delft97::LoadCoefficients<T>& c) {
    return c.Fz * (p.pTy8 + p.pTy9 * c.dfz) * c.gamma;  // (24)
}

template <class T>
T gyroscopicLateralForce(const BasicTyreCoefficients<T>& p, const BasicTyreMotion<T>& motion) {
    return p.cygyr * p.Ro * p.mt * motion.Omega * motion.psidot;  // (26)
}

// Slip velocity of the patch per dv, with the yaw of the belt that the gyroscopic couple causes (19).
template <class T>
T lateralSlope(const BasicTyreCoefficients<T>& p, const BasicTyreMotion<T>& motion) {
    return 1 + p.cpsigyr * p.czgyr * p.mt / (p.Ro * p.cFy) * motion.Vx * motion.Omega;  // (25), (27)
}

template <class T>
BasicTyreForces<T> rimForces(const TyreOf<T>& tyre, const delft97::LoadCoefficients<T>& c,
                             const BasicTyreState<T>& state, const delft97::HorizontalForces<T>& f,
                             const BasicTyreMotion<T>& motion, const Relaxation<T>& relax) {
    const auto& [p, l] = tyre;
    const T c_alpha = delft97::cosineOfSlipAngle(motion.Vx, motion.Vsy);
    const auto m = delft97::aligningTorque(p, l, c, state.kappa, state.alpha, f, c_alpha);

    BasicTyreForces<T> forces;
    forces.Fx = relax.kFx(p) * state.du + p.cFx * state.u;  // (21)
    forces.Fy = relax.kFy(p) * state.dv + p.cFy * state.v + nonLaggingCamberForce(p, c) -
                gyroscopicLateralForce(p, motion);  // (22)
    forces.Mx = delft97::overturningCouple(p, l, c, forces.Fy);
    forces.My = delft97::rollingResistanceTorque(p, l, c, forces.Fx, T(motion.Vx - motion.Vsx));
    forces.Mz = m.Mz - p.czgyr * p.Ro * p.mt * motion.Omega * state.dv;  // (23)
    return forces;
}

// ---- The two stages of a step ----

template <class T>
Stage<T> stageAt(const TyreOf<T>& tyre, const delft97::LoadCoefficients<T>& c, const BasicTyreState<T>& base,
                 const BasicTyreMotion<T>& motion, double step, const Relaxation<T>& relax) {
    const BasicTyreCoefficients<T>& p = tyre.p;
    return {.p = p,
            .l = tyre.l,
            .c = c,
            .base = base,
            .step = step,
            .Vsx = {motion.Vsx, 0},
            .Vsy = motion.Vsy,
            .Vsy_slope = lateralSlope(p, motion),
            .speed = relax.speed(motion.Vx),
            .sigma = relax.length,
            .kFx = relax.kFx(p),
            .kFy = relax.kFy(p),
            .Fy_direct = gyroscopicLateralForce(p, motion) - nonLaggingCamberForce(p, c),
            .limit = slipLimit(c, relax.weight)};
}

// State at the end of a stage whose patch velocity is known.
template <class T>
BasicTyreState<T> stateAt(const Stage<T>& s, const Patch<T>& patch) {
    const auto& [du, dv] = patch.velocity;
    return {s.base.u + s.step * du, s.base.v + s.step * dv, du, dv, patch.slip.kappa, patch.slip.alpha};
}

// Base of the second stage: the first stage's slope carried over (1 - gamma) h from the start of the step.
template <class T>
T carried(const T& start, const T& stage) {
    return start + (1 - kGamma) / kGamma * (stage - start);
}
template <class T>
BasicTyreState<T> carried(const BasicTyreState<T>& start, const BasicTyreState<T>& stage) {
    return {carried(start.u, stage.u),   carried(start.v, stage.v),         carried(start.du, stage.du),
            carried(start.dv, stage.dv), carried(start.kappa, stage.kappa), carried(start.alpha, stage.alpha)};
}

// States decay towards zero for ever; subnormal numbers would make every later operation slow.
template <class T>
void snapToZero(BasicTyreState<T>& state) {
    constexpr double kTiny = 1e-150;
    for (T* x : {&state.u, &state.v, &state.du, &state.dv, &state.kappa, &state.alpha}) {
        *x = select(magnitude(*x) < T(kTiny), T(0), *x);
    }
}

// One step of a wheel whose motion, spin included, is given.
template <class T>
struct GivenSpin {
    BasicTyreForces<T> step(BasicTyreState<T>& state, T&, const TyreOf<T>& tyre, const BasicTyreMotion<T>& begin,
                            const BasicTyreMotion<T>& end, double dt, Standstill standstill) const {
        const double h = kGamma * dt;
        const Relaxation<T> relax = relaxation(tyre.p, begin, standstill);

        // First stage, at gamma h.
        const BasicTyreMotion<T> early = between(begin, end, kGamma);
        const auto c1 = delft97::loadCoefficients(tyre.p, tyre.l, early.Fz, early.gamma);
        const Stage<T> first = stageAt(tyre, c1, state, early, h, relax);
        const Patch<T> patch1 = solve(first, {state.du, state.dv});

        // Second stage, at h: its result is the end of the step.
        const auto c2 = delft97::loadCoefficients(tyre.p, tyre.l, end.Fz, end.gamma);
        const Stage<T> second = stageAt(tyre, c2, carried(state, stateAt(first, patch1)), end, h, relax);
        const Patch<T> patch2 = solve(second, patch1.velocity);

        state = stateAt(second, patch2);
        snapToZero(state);
        return rimForces(tyre, c2, state, patch2.forces, end, relax);
    }
};

// One step of a wheel that spins freely under torques.
template <class T>
struct FreeSpin {
    const BasicTyreSpin<T>& spin;

    BasicTyreForces<T> step(BasicTyreState<T>& state, T& Omega, const TyreOf<T>& tyre, const BasicTyreMotion<T>& begin,
                            const BasicTyreMotion<T>& end, double dt, Standstill standstill) const {
        const BasicTyreCoefficients<T>& p = tyre.p;
        const double h = kGamma * dt;
        BasicTyreMotion<T> start = begin;
        start.Omega = Omega;
        start.Vsx =
            begin.Vx - delft97::rollingRadius(p, delft97::loadIncrement(p, tyre.l, larger(begin.Fz, T(0)))) * Omega;
        const Relaxation<T> relax = relaxation(p, start, standstill);
        const T Fx = relax.kFx(p) * state.du + p.cFx * state.u;
        const auto freeTorque = [&](const delft97::LoadCoefficients<T>& c, const T& speed) {
            return T(spin.drive_torque - delft97::rollingResistanceTorque(p, tyre.l, c, Fx, T(c.Re * speed)));
        };

        // First stage, at gamma h. The belt's gyroscopic effects take the spin from which the stage starts. c2 waits
        // for nothing that comes later, so it is computed while c1 is.
        BasicTyreMotion<T> early = between(start, end, kGamma);
        early.Omega = Omega;
        const auto c1 = delft97::loadCoefficients(p, tyre.l, early.Fz, early.gamma);
        const auto c2 = delft97::loadCoefficients(p, tyre.l, end.Fz, end.gamma);
        Stage<T> first = stageAt(tyre, c1, state, early, h, relax);
        const Solution<T> s1 =
            solveSpin(first, {spin, Omega, freeTorque(c1, Omega), c1.Re}, early.Vx, {state.du, state.dv});

        // Second stage, at h: its result is the end of the step.
        const T base = carried(Omega, s1.Omega);
        BasicTyreMotion<T> late = end;
        late.Omega = s1.Omega;
        Stage<T> second = stageAt(tyre, c2, carried(state, stateAt(first, s1.patch)), late, h, relax);
        const Solution<T> s2 =
            solveSpin(second, {spin, base, freeTorque(c2, s1.Omega), c2.Re}, end.Vx, s1.patch.velocity);

        state = stateAt(second, s2.patch);
        Omega = s2.Omega;
        snapToZero(state);
        late.Omega = Omega;
        late.Vsx = end.Vx - c2.Re * Omega;
        return rimForces(tyre, c2, state, s2.patch.forces, late, relax);
    }
};

// ---- Refinement ----

// A step is repeated in finer ones where one is too coarse. That is decided by the physics alone, not by the length of
// the step, so that halving the step still quarters the error.
inline constexpr int kRefinementPaper = 16;
inline constexpr int kRefinementHold = 4;  // in the car: a rare millisecond may cost four times the others
// The contact mass rings at about 100 Hz after a jump, and for long where the characteristic falls: its inertia force
// is then more than this share of the load.
inline constexpr double kRinging = 0.005;
// In the paper's slip, below this speed the falling characteristic is steeper than the impedance of the contact mass
// over 1 ms: the implicit equation would have a sticking and a sliding solution.
inline constexpr double kSlowSpeed = 1.0;  // m/s

template <class T>
MaskOf<T> needsRefinement(const BasicTyreCoefficients<T>& p, const BasicTyreState<T>& before,
                          const BasicTyreState<T>& after, const BasicTyreMotion<T>& end, double dt,
                          Standstill standstill) {
    const T change = larger(magnitude(T(after.du - before.du)), magnitude(T(after.dv - before.dv)));
    const T inertia_force = p.mc * change / dt;
    const auto rings = inertia_force > kRinging * larger(end.Fz, T(0.1 * p.Fzo));
    if (standstill == Standstill::hold) return rings;
    return rings | (magnitude(end.Vx) < T(kSlowSpeed));
}

// Advances contact patch and spin once over the step, or in finer steps where one is too coarse.
template <class T, class Spin>
BasicTyreForces<T> advance(BasicTyreState<T>& state, T& Omega, const TyreOf<T>& tyre, const BasicTyreMotion<T>& begin,
                           const BasicTyreMotion<T>& end, const Spin& spin, double dt, Standstill standstill) {
    BasicTyreState<T> fine = state;
    T fine_Omega = Omega;
    const BasicTyreForces<T> forces = spin.step(state, Omega, tyre, begin, end, dt, standstill);
    const auto coarse = needsRefinement(tyre.p, fine, state, end, dt, standstill);
    if (!any(coarse)) return forces;

    BasicTyreForces<T> fine_forces;
    const int n = standstill == Standstill::paper ? kRefinementPaper : kRefinementHold;
    for (int i = 0; i < n; ++i) {
        fine_forces = spin.step(fine, fine_Omega, tyre, between(begin, end, static_cast<double>(i) / n),
                                between(begin, end, (i + 1.0) / n), dt / n, standstill);
    }
    state = select(coarse, fine, state);
    Omega = select(coarse, fine_Omega, Omega);
    return select(coarse, fine_forces, forces);
}

}  // namespace TREAD_ISA
}  // namespace tread
