// One implicit stage of the contact patch: the unknowns are the patch velocities du and dv; u, v, the slip and the
// wheel spin are affine in them. Solved by a damped Newton. T is double, or Lanes for four wheels at once: a lane that
// has converged keeps its result while the others go on, so that it gets the bits that it would get alone.
#pragma once

#include "tyre/standstill.h"

namespace tread {
inline namespace TREAD_ISA {

inline constexpr int kNewtonIterations = 20;  // reached only when a wheel starts from rest in the paper's slip
inline constexpr int kBacktracks = 8;
// A Newton update that moves the slip by less than this is the last one: the error left is quadratic in it, about 1e-6
// of the peak force.
inline constexpr double kSlipTolerance = 1e-4;
// A falling characteristic may soften the Jacobian only down to this share of the mechanical impedance, so that the
// Newton step always points downhill.
inline constexpr double kSlopeFloor = -0.5;

template <class T>
struct PatchVelocity {
    T du = 0;
    T dv = 0;
};

// A rim slip velocity that may depend on the patch velocity of its stage: value + slope * (du or dv).
template <class T>
struct Affine {
    T value = 0;
    T slope = 0;
    T at(const T& x) const { return value + slope * x; }
};

// Everything that stays fixed while Newton solves a stage.
template <class T>
struct Stage {
    const BasicTyreCoefficients<T>& p;
    const BasicTyreScaling<T>& l;
    const delft97::LoadCoefficients<T>& c;
    BasicTyreState<T> base;  // state from which the stage starts
    double step;             // gamma h
    Affine<T> Vsx;           // slip velocity of the rim, without du
    T Vsy;                   // slip velocity of the rim
    T Vsy_slope;             // slip velocity of the patch per dv: 1 and the belt yaw (19), (27)
    T speed;                 // |Vx|'
    T sigma;                 // relaxation length of the contact patch, 0 in the paper
    T kFx, kFy;              // carcass damping
    T Fy_direct;             // Fygyr - FyNL (18)
    SlipLimit<T> limit;

    // Slip of the contact patch (32), (33); with its relaxation sigma dkappa/dt + |Vx|' kappa = -Vsx*.
    Slip<T> slip(const PatchVelocity<T>& x) const {
        const T inverse = 1 / (sigma + step * speed);
        return limit({(sigma * base.kappa - step * (Vsx.at(x.du) + x.du)) * inverse,
                      (sigma * base.alpha - step * (Vsy + Vsy_slope * x.dv)) * inverse});
    }
    T slipPerVelocity() const { return -step / (sigma + step * speed); }
};

template <class T>
struct Residual {
    Slip<T> slip;                               // of the contact patch
    delft97::HorizontalForces<Dual<T>> forces;  // at that slip
    T x = 0, y = 0;                             // N, imbalance of (17) and (18)
    T xx = 0, xy = 0, yx = 0, yy = 0;           // N s/m, its derivatives with respect to du, dv
    T size() const { return x * x + y * y; }
};

// A solved stage: patch velocities, slip and forces F*.
template <class T>
struct Patch {
    PatchVelocity<T> velocity;
    Slip<T> slip;
    delft97::HorizontalForces<T> forces;
};

template <class T>
Residual<T> residual(const Stage<T>& s, const PatchVelocity<T>& at) {
    Residual<T> r;
    r.slip = s.slip(at);
    r.forces = delft97::horizontalForces(s.p, s.l, s.c, Dual<T>(r.slip.kappa, 1, 0), Dual<T>(r.slip.alpha, 0, 1));
    const auto& f = r.forces;
    const T mass_rate = s.p.mc / s.step;
    const T impedance_x = mass_rate + s.kFx + s.step * s.p.cFx;
    const T impedance_y = mass_rate + s.kFy + s.step * s.p.cFy;

    r.x = impedance_x * at.du - mass_rate * s.base.du + s.p.cFx * s.base.u - f.Fx.value;                // (17)
    r.y = impedance_y * at.dv - mass_rate * s.base.dv + s.p.cFy * s.base.v - f.Fy.value - s.Fy_direct;  // (18)
    const T per_du = s.slipPerVelocity() * (1 + s.Vsx.slope);
    const T per_dv = s.slipPerVelocity() * s.Vsy_slope;
    r.xx = impedance_x + larger(T(-f.Fx.by_kappa * per_du), T(kSlopeFloor * impedance_x));
    r.yy = impedance_y + larger(T(-f.Fy.by_alpha * per_dv), T(kSlopeFloor * impedance_y));
    r.xy = -f.Fx.by_alpha * per_dv;
    r.yx = -f.Fy.by_kappa * per_du;
    return r;
}

template <class T>
PatchVelocity<T> newtonStep(const Residual<T>& r) {
    // Without its cross terms where they would spoil the direction downhill.
    const auto keep = r.xx * r.yy - r.xy * r.yx >= 0.1 * r.xx * r.yy;
    const T xy = select(keep, r.xy, T(0));
    const T yx = select(keep, r.yx, T(0));
    const T inverse = 1 / (r.xx * r.yy - xy * yx);
    return {-(r.yy * r.x - xy * r.y) * inverse, -(r.xx * r.y - yx * r.x) * inverse};
}

// The solution one short Newton step away from an evaluated point: forces follow along their slopes.
template <class T>
Patch<T> extrapolate(const Residual<T>& r, const PatchVelocity<T>& velocity, const Slip<T>& slip) {
    const T d_kappa = slip.kappa - r.slip.kappa;
    const T d_alpha = slip.alpha - r.slip.alpha;
    const auto follow = [&](const Dual<T>& x) { return T(x.value + x.by_kappa * d_kappa + x.by_alpha * d_alpha); };
    return {velocity,
            slip,
            {.Fx = follow(r.forces.Fx),
             .Fy = follow(r.forces.Fy),
             .Fx0 = follow(r.forces.Fx0),
             .Fy0 = follow(r.forces.Fy0),
             .SVyk = follow(r.forces.SVyk)}};
}

template <class T>
PatchVelocity<T> moved(const PatchVelocity<T>& x, const PatchVelocity<T>& step) {
    return {x.du + step.du, x.dv + step.dv};
}

template <class T>
Patch<T> solve(const Stage<T>& s, PatchVelocity<T> x) {
    using Mask = MaskOf<T>;
    Residual<T> r = residual(s, x);
    Patch<T> solution;
    Mask open = r.size() == r.size();  // lanes that are not solved yet; one that is not a number never will be
    for (int iteration = 0; iteration < kNewtonIterations; ++iteration) {
        PatchVelocity<T> step = newtonStep(r);
        const PatchVelocity<T> target = moved(x, step);
        const Slip<T> slip = s.slip(target);
        const T change = magnitude(T(slip.kappa - r.slip.kappa)) + magnitude(T(slip.alpha - r.slip.alpha));
        const Mask close = change <= kSlipTolerance * (1 + magnitude(slip.kappa) + magnitude(slip.alpha));
        const Mask solved = open & close;
        if (all(solved)) return extrapolate(r, target, slip);      // as a rule at once, and together
        if (iteration == 0) solution = extrapolate(r, x, r.slip);  // of a lane that never will be
        if (any(solved)) solution = select(solved, extrapolate(r, target, slip), solution);
        open = open & (!close);
        if (!any(open)) break;

        // Halve the step until the imbalance shrinks.
        Residual<T> next = residual(s, moved(x, step));
        for (int i = 0; i < kBacktracks; ++i) {
            const Mask shrunk = (!open) | (next.size() < r.size());
            if (all(shrunk)) break;
            step = select(shrunk, step, PatchVelocity<T>{0.5 * step.du, 0.5 * step.dv});
            next = select(shrunk, next, residual(s, moved(x, step)));
        }
        x = select(open, moved(x, step), x);
        r = select(open, next, r);
    }
    if (any(open)) solution = select(open, extrapolate(r, x, r.slip), solution);
    return solution;
}

}  // namespace TREAD_ISA
}  // namespace tread
