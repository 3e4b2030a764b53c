// The transient part of Delft Tyre 97: contact-patch mass on the carcass, gyroscopic effects of the belt, wheel spin.
// Equations (17)-(28) of Pacejka & Besselink (1997), integrated by the two-stage SDIRK method with
// gamma = 1 - 1/sqrt(2): second order, L-stable and stiffly accurate, which the slip damper (up to 8e6 1/s near
// standstill) and the contact mass (600 rad/s) ask for. The unknowns of a stage are the patch velocities du and dv;
// u, v, the slip and the wheel spin are affine in them.

#include <array>
#include <cmath>
#include <numbers>

#include "tread/tyre.h"
#include "tyre/delft97.h"

namespace tread {
namespace {

using delft97::kEpsX;

constexpr double kGamma = 1 - 1 / std::numbers::sqrt2;  // SDIRK2
constexpr int kNewtonIterations = 20;  // reached only when a wheel starts from rest in the paper's slip
constexpr int kBacktracks = 8;
// A Newton update that moves the slip by less than this is the last one: the error left is quadratic in it, about 1e-6
// of the peak force.
constexpr double kSlipTolerance = 1e-4;
// A falling characteristic may soften the Jacobian only down to this share of the mechanical impedance, so that the
// Newton step always points downhill.
constexpr double kSlopeFloor = -0.5;

// Standstill extension: speeds between which the contact patch's own relaxation fades out.
constexpr double kFullHoldSpeed = 1.0;  // m/s
constexpr double kNoHoldSpeed = 2.0;    // m/s
// Half the contact length over the chord that a circle of radius Ro cuts at the nominal deflection (a loaded tyre
// flattens over about half that chord).
constexpr double kContactLengthShare = 0.5;
// Loss of the carcass near standstill, as damping over stiffness: rubber loses about 15 % per radian at the 5 Hz at
// which a car rocks on its tyres. Without it a parked car would rock for minutes after each touch.
constexpr double kHysteresisTime = 0.005;  // s

struct Slip {
    double kappa = 0;
    double alpha = 0;
};

struct PatchVelocity {
    double du = 0;
    double dv = 0;
};

// A rim slip velocity that may depend on the patch velocity of its stage: value + slope * (du or dv).
struct Affine {
    double value = 0;
    double slope = 0;
    double at(double x) const { return value + slope * x; }
};

// ---- Standstill extension ----

struct Relaxation {
    double length = 0;  // m, sigma_c faded by speed; 0: the paper's slip
    double weight = 0;  // 0: paper ... 1: full hold

    // |Vx|' of (31); in full hold the floor goes, or a held wheel would creep.
    double speed(double Vx) const { return std::max(std::abs(Vx), kEpsX * (1 - weight)); }

    // Carcass damping (17), (18).
    double kFx(const TyreCoefficients& p) const { return p.kFx + weight * kHysteresisTime * p.cFx; }
    double kFy(const TyreCoefficients& p) const { return p.kFy + weight * kHysteresisTime * p.cFy; }
};

Relaxation relaxation(const TyreCoefficients& p, const TyreMotion& motion, Standstill standstill) {
    if (standstill == Standstill::paper) return {};
    const double speed = std::sqrt(motion.Vx * motion.Vx + motion.Vsx * motion.Vsx + motion.Vsy * motion.Vsy);
    if (speed >= kNoHoldSpeed) return {};
    const double x = std::clamp((kNoHoldSpeed - speed) / (kNoHoldSpeed - kFullHoldSpeed), 0.0, 1.0);
    const double weight = x * x * (3 - 2 * x);
    const double half_length = kContactLengthShare * std::sqrt(2 * p.Ro * p.Fzo / p.pz1);
    return {half_length * weight, weight};
}

// Slip at which a sine form has its peak: C arctan(x - E (x - arctan x)) = pi / 2.
double peakSlip(double B, double C, double E) {
    constexpr double kNoPeak = 5;  // x beyond which a curve with C <= 1 is flat
    double x = kNoPeak;
    if (C > 1) {
        const double target = std::tan(std::numbers::pi / 2 / C);
        x = target;
        for (int i = 0; i < 5 && x < kNoPeak; ++i) {
            const double rest = x - E * (x - std::atan(x)) - target;
            x -= rest / (1 - E + E / (1 + x * x));
        }
        if (!(x > 0 && x < kNoPeak)) x = kNoPeak;
    }
    return B > 0 ? x / B : kNoPeak;
}

// The slip state must not wind up behind the force peak, or the patch would rebound over it when it lets go.
struct SlipLimit {
    double kappa_peak = 1;
    double alpha_peak = 1;
    double limit = kInfinity;  // in units of the peak slip

    Slip operator()(Slip slip) const {
        if (limit == kInfinity) return slip;
        const double x = slip.kappa / kappa_peak;
        const double y = slip.alpha / alpha_peak;
        const double size = std::sqrt(x * x + y * y);
        if (size <= limit) return slip;
        return {slip.kappa * limit / size, slip.alpha * limit / size};
    }
};

SlipLimit slipLimit(const delft97::LoadCoefficients& c, double weight) {
    if (weight == 0) return {};
    return {peakSlip(c.Bx, c.Cx, c.Ex_brake), peakSlip(c.By, c.Cy, c.Ey_positive), 1 / weight};
}

// ---- One implicit stage ----

// Everything that stays fixed while Newton solves a stage.
struct Stage {
    const TyreCoefficients& p;
    const TyreScaling& l;
    const delft97::LoadCoefficients& c;
    TyreState base;    // state from which the stage starts
    double step;       // gamma h
    Affine Vsx;        // slip velocity of the rim, without du
    double Vsy;        // slip velocity of the rim
    double Vsy_slope;  // slip velocity of the patch per dv: 1 and the belt yaw (19), (27)
    double speed;      // |Vx|'
    double sigma;      // relaxation length of the contact patch, 0 in the paper
    double kFx, kFy;   // carcass damping
    double Fy_direct;  // Fygyr - FyNL (18)
    SlipLimit limit;

    // Slip of the contact patch (32), (33); with its relaxation sigma dkappa/dt + |Vx|' kappa = -Vsx*.
    Slip slip(const PatchVelocity& x) const {
        const double inverse = 1 / (sigma + step * speed);
        return limit({(sigma * base.kappa - step * (Vsx.at(x.du) + x.du)) * inverse,
                      (sigma * base.alpha - step * (Vsy + Vsy_slope * x.dv)) * inverse});
    }
    double slipPerVelocity() const { return -step / (sigma + step * speed); }
};

struct Residual {
    Slip slip;                               // of the contact patch
    delft97::HorizontalForces<Dual> forces;  // at that slip
    double x = 0, y = 0;                     // N, imbalance of (17) and (18)
    double xx = 0, xy = 0, yx = 0, yy = 0;   // N s/m, its derivatives with respect to du, dv
    double size() const { return x * x + y * y; }
};

// A solved stage: patch velocities, slip and forces F*.
struct Patch {
    PatchVelocity velocity;
    Slip slip;
    delft97::HorizontalForces<double> forces;
};

Residual residual(const Stage& s, const PatchVelocity& at) {
    Residual r;
    r.slip = s.slip(at);
    r.forces = delft97::horizontalForces<Dual>(s.p, s.l, s.c, {r.slip.kappa, 1, 0}, {r.slip.alpha, 0, 1});
    const auto& f = r.forces;
    const double mass_rate = s.p.mc / s.step;
    const double impedance_x = mass_rate + s.kFx + s.step * s.p.cFx;
    const double impedance_y = mass_rate + s.kFy + s.step * s.p.cFy;

    r.x = impedance_x * at.du - mass_rate * s.base.du + s.p.cFx * s.base.u - f.Fx.value;                // (17)
    r.y = impedance_y * at.dv - mass_rate * s.base.dv + s.p.cFy * s.base.v - f.Fy.value - s.Fy_direct;  // (18)
    const double per_du = s.slipPerVelocity() * (1 + s.Vsx.slope);
    const double per_dv = s.slipPerVelocity() * s.Vsy_slope;
    r.xx = impedance_x + std::max(-f.Fx.by_kappa * per_du, kSlopeFloor * impedance_x);
    r.yy = impedance_y + std::max(-f.Fy.by_alpha * per_dv, kSlopeFloor * impedance_y);
    r.xy = -f.Fx.by_alpha * per_dv;
    r.yx = -f.Fy.by_kappa * per_du;
    return r;
}

PatchVelocity newtonStep(const Residual& r) {
    double xy = r.xy, yx = r.yx;
    if (r.xx * r.yy - xy * yx < 0.1 * r.xx * r.yy) xy = yx = 0;  // keeps the direction downhill
    const double inverse = 1 / (r.xx * r.yy - xy * yx);
    return {-(r.yy * r.x - xy * r.y) * inverse, -(r.xx * r.y - yx * r.x) * inverse};
}

// The solution one short Newton step away from an evaluated point: forces follow along their slopes.
Patch extrapolate(const Residual& r, const PatchVelocity& velocity, const Slip& slip) {
    const double d_kappa = slip.kappa - r.slip.kappa;
    const double d_alpha = slip.alpha - r.slip.alpha;
    const auto follow = [&](const Dual& x) { return x.value + x.by_kappa * d_kappa + x.by_alpha * d_alpha; };
    return {velocity,
            slip,
            {.Fx = follow(r.forces.Fx),
             .Fy = follow(r.forces.Fy),
             .Fx0 = follow(r.forces.Fx0),
             .Fy0 = follow(r.forces.Fy0),
             .SVyk = follow(r.forces.SVyk)}};
}

Patch solve(const Stage& s, PatchVelocity x) {
    Residual r = residual(s, x);
    for (int iteration = 0; iteration < kNewtonIterations; ++iteration) {
        PatchVelocity step = newtonStep(r);
        const PatchVelocity target{x.du + step.du, x.dv + step.dv};
        const Slip slip = s.slip(target);
        const double moved = std::abs(slip.kappa - r.slip.kappa) + std::abs(slip.alpha - r.slip.alpha);
        if (moved <= kSlipTolerance * (1 + std::abs(slip.kappa) + std::abs(slip.alpha))) {
            return extrapolate(r, target, slip);
        }

        // Halve the step until the imbalance shrinks.
        Residual next;
        for (int i = 0; i < kBacktracks; ++i) {
            next = residual(s, {x.du + step.du, x.dv + step.dv});
            if (next.size() < r.size()) break;
            step = {0.5 * step.du, 0.5 * step.dv};
        }
        x = {x.du + step.du, x.dv + step.dv};
        r = next;
    }
    return extrapolate(r, x, r.slip);
}

// ---- The two stages of a step ----

TyreMotion between(const TyreMotion& a, const TyreMotion& b, double share) {
    const auto mix = [share](double x, double y) { return x + share * (y - x); };
    return {mix(a.Vsx, b.Vsx),       mix(a.Vsy, b.Vsy),     mix(a.Vx, b.Vx), mix(a.Omega, b.Omega),
            mix(a.psidot, b.psidot), mix(a.gamma, b.gamma), mix(a.Fz, b.Fz)};
}

double nonLaggingCamberForce(const TyreCoefficients& p, const delft97::LoadCoefficients& c) {
    return c.Fz * (p.pTy8 + p.pTy9 * c.dfz) * c.gamma;  // (24)
}

double gyroscopicLateralForce(const TyreCoefficients& p, const TyreMotion& motion) {
    return p.cygyr * p.Ro * p.mt * motion.Omega * motion.psidot;  // (26)
}

// Slip velocity of the patch per dv, with the yaw of the belt that the gyroscopic couple causes (19).
double lateralSlope(const TyreCoefficients& p, const TyreMotion& motion) {
    return 1 + p.cpsigyr * p.czgyr * p.mt / (p.Ro * p.cFy) * motion.Vx * motion.Omega;  // (25), (27)
}

Stage stageAt(const TyreParams& tyre, const delft97::LoadCoefficients& c, const TyreState& base,
              const TyreMotion& motion, double step, const Relaxation& relax) {
    const TyreCoefficients& p = tyre.parameters;
    return {.p = p,
            .l = tyre.lambda,
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
TyreState stateAt(const Stage& s, const Patch& patch) {
    const auto [du, dv] = patch.velocity;
    return {s.base.u + s.step * du, s.base.v + s.step * dv, du, dv, patch.slip.kappa, patch.slip.alpha};
}

// Base of the second stage: the first stage's slope carried over (1 - gamma) h from the start of the step.
double carried(double start, double stage) {
    return start + (1 - kGamma) / kGamma * (stage - start);
}

TyreState carried(const TyreState& start, const TyreState& stage) {
    return {carried(start.u, stage.u),   carried(start.v, stage.v),         carried(start.du, stage.du),
            carried(start.dv, stage.dv), carried(start.kappa, stage.kappa), carried(start.alpha, stage.alpha)};
}

TyreForces rimForces(const TyreParams& tyre, const delft97::LoadCoefficients& c, const TyreState& state,
                     const delft97::HorizontalForces<double>& f, const TyreMotion& motion, const Relaxation& relax) {
    const TyreCoefficients& p = tyre.parameters;
    const TyreScaling& l = tyre.lambda;
    const double c_alpha = delft97::cosineOfSlipAngle(motion.Vx, motion.Vsy);
    const auto m = delft97::aligningTorque(p, l, c, state.kappa, state.alpha, f, c_alpha);

    TyreForces forces;
    forces.Fx = relax.kFx(p) * state.du + p.cFx * state.u;  // (21)
    forces.Fy = relax.kFy(p) * state.dv + p.cFy * state.v + nonLaggingCamberForce(p, c) -
                gyroscopicLateralForce(p, motion);  // (22)
    forces.Mx = delft97::overturningCouple(p, l, c, forces.Fy);
    forces.My = delft97::rollingResistanceTorque(p, l, c, forces.Fx, motion.Vx - motion.Vsx);
    forces.Mz = m.Mz - p.czgyr * p.Ro * p.mt * motion.Omega * state.dv;  // (23)
    return forces;
}

// States decay towards zero for ever; subnormal numbers would make every later operation slow.
void snapToZero(TyreState& state) {
    constexpr double kTiny = 1e-150;
    for (double* x : {&state.u, &state.v, &state.du, &state.dv, &state.kappa, &state.alpha}) {
        if (std::abs(*x) < kTiny) *x = 0;
    }
}

// ---- Wheel spin ----

// The spin at the end of a stage, I dOmega/dt = torque - radius Fx, with Fx = kFx du + cFx u (21): affine in du.
struct SpinStage {
    const TyreSpin& wheel;
    double base;         // Omega from which the stage starts
    double torque_free;  // drive and rolling resistance
    double Re;

    Affine omega(const Stage& s, double brake_torque) const {
        const double rate = s.step / wheel.inertia;
        return {base + rate * (torque_free + brake_torque - wheel.radius * s.p.cFx * s.base.u),
                -rate * wheel.radius * (s.kFx + s.step * s.p.cFx)};
    }
};

struct Solution {
    Patch patch;
    double Omega;
};

Solution solveSliding(Stage& s, const SpinStage& spin, double Vx, double brake_torque, const PatchVelocity& guess) {
    const Affine omega = spin.omega(s, brake_torque);
    s.Vsx = {Vx - spin.Re * omega.value, -spin.Re * omega.slope};
    const Patch patch = solve(s, guess);
    return {patch, omega.at(patch.velocity.du)};
}

// Coulomb brake: the wheel stays locked while the torque that this needs is within the brake's capacity; else the brake
// opposes the spin.
Solution solveSpin(Stage& s, const SpinStage& spin, double Vx, const PatchVelocity& guess) {
    const double capacity = spin.wheel.brake_torque;
    if (capacity <= 0) return solveSliding(s, spin, Vx, 0, guess);

    if (spin.base != 0) {
        const double sign = spin.base > 0 ? 1 : -1;
        const Solution rolling = solveSliding(s, spin, Vx, -sign * capacity, guess);
        if (rolling.Omega * sign > 0) return rolling;
    }
    s.Vsx = {Vx, 0};
    const Patch locked = solve(s, guess);
    const double needed = -spin.omega(s, 0).at(locked.velocity.du) * spin.wheel.inertia /
                          s.step;  // brake torque that keeps Omega at zero
    if (std::abs(needed) <= capacity) return {locked, 0};
    return solveSliding(s, spin, Vx, std::copysign(capacity, needed), guess);
}

TyreForces step(TyreState& state, const TyreParams& tyre, const TyreMotion& begin, const TyreMotion& end, double dt,
                Standstill standstill) {
    const double step = kGamma * dt;
    const Relaxation relax = relaxation(tyre.parameters, begin, standstill);

    // First stage, at gamma h.
    const TyreMotion early = between(begin, end, kGamma);
    const auto c1 = delft97::loadCoefficients(tyre.parameters, tyre.lambda, early.Fz, early.gamma);
    const Stage first = stageAt(tyre, c1, state, early, step, relax);
    const Patch patch1 = solve(first, {state.du, state.dv});

    // Second stage, at h: its result is the end of the step.
    const auto c2 = delft97::loadCoefficients(tyre.parameters, tyre.lambda, end.Fz, end.gamma);
    const Stage second = stageAt(tyre, c2, carried(state, stateAt(first, patch1)), end, step, relax);
    const Patch patch2 = solve(second, patch1.velocity);

    state = stateAt(second, patch2);
    snapToZero(state);
    return rimForces(tyre, c2, state, patch2.forces, end, relax);
}

TyreForces step(TyreState& state, double& Omega, const TyreParams& tyre, const TyreMotion& begin, const TyreMotion& end,
                const TyreSpin& spin, double dt, Standstill standstill) {
    const TyreCoefficients& p = tyre.parameters;
    const double step = kGamma * dt;
    TyreMotion start = begin;
    start.Omega = Omega;
    start.Vsx = begin.Vx - p.Re * Omega;
    const Relaxation relax = relaxation(p, start, standstill);
    const double Fx = relax.kFx(p) * state.du + p.cFx * state.u;
    const auto freeTorque = [&](const delft97::LoadCoefficients& c, double spin_speed) {
        return spin.drive_torque - delft97::rollingResistanceTorque(p, tyre.lambda, c, Fx, p.Re * spin_speed);
    };

    // First stage, at gamma h. The belt's gyroscopic effects take the spin from which the stage starts.
    TyreMotion early = between(start, end, kGamma);
    early.Omega = Omega;
    const auto c1 = delft97::loadCoefficients(p, tyre.lambda, early.Fz, early.gamma);
    Stage first = stageAt(tyre, c1, state, early, step, relax);
    const Solution s1 = solveSpin(first, {spin, Omega, freeTorque(c1, Omega), p.Re}, early.Vx, {state.du, state.dv});

    // Second stage, at h: its result is the end of the step.
    const double base = carried(Omega, s1.Omega);
    TyreMotion late = end;
    late.Omega = s1.Omega;
    const auto c2 = delft97::loadCoefficients(p, tyre.lambda, end.Fz, end.gamma);
    Stage second = stageAt(tyre, c2, carried(state, stateAt(first, s1.patch)), late, step, relax);
    const Solution s2 = solveSpin(second, {spin, base, freeTorque(c2, s1.Omega), p.Re}, end.Vx, s1.patch.velocity);

    state = stateAt(second, s2.patch);
    Omega = s2.Omega;
    snapToZero(state);
    late.Omega = Omega;
    late.Vsx = end.Vx - p.Re * Omega;
    return rimForces(tyre, c2, state, s2.patch.forces, late, relax);
}

// ---- Refinement ----

// A step is repeated in finer ones where one is too coarse. That is decided by the physics alone, not by the length of
// the step, so that halving the step still quarters the error.
constexpr int kRefinementPaper = 16;
constexpr int kRefinementHold = 4;  // in the car: a rare millisecond may cost four times the others
// The contact mass rings at about 100 Hz after a jump, and for long where the characteristic falls: its inertia force
// is then more than this share of the load.
constexpr double kRinging = 0.005;
// In the paper's slip, below this speed the falling characteristic is steeper than the impedance of the contact mass
// over 1 ms: the implicit equation would have a sticking and a sliding solution.
constexpr double kSlowSpeed = 1.0;  // m/s

bool needsRefinement(const TyreParams& tyre, const TyreState& before, const TyreState& after, const TyreMotion& end,
                     double dt, Standstill standstill) {
    if (standstill == Standstill::paper && std::abs(end.Vx) < kSlowSpeed) return true;
    const double change = std::max(std::abs(after.du - before.du), std::abs(after.dv - before.dv));
    const double inertia_force = tyre.parameters.mc * change / dt;
    return inertia_force > kRinging * std::max(end.Fz, 0.1 * tyre.parameters.Fzo);
}

int refinement(Standstill standstill) {
    return standstill == Standstill::paper ? kRefinementPaper : kRefinementHold;
}

// Runs `take(from, to, dt)` once over the step, or in finer steps where one is too coarse.
template <class Take>
TyreForces refined(TyreState& state, double& Omega, const TyreParams& tyre, const TyreMotion& begin,
                   const TyreMotion& end, double dt, Standstill standstill, Take take) {
    const TyreState before = state;
    const double Omega_before = Omega;
    TyreForces forces = take(begin, end, dt);
    if (!needsRefinement(tyre, before, state, end, dt, standstill)) return forces;

    state = before;
    Omega = Omega_before;
    const int n = refinement(standstill);
    for (int i = 0; i < n; ++i) {
        forces = take(between(begin, end, static_cast<double>(i) / n), between(begin, end, (i + 1.0) / n), dt / n);
    }
    return forces;
}

}  // namespace

TyreForces rimForces(const TyreState& state, const TyreParams& tyre, const TyreMotion& motion, Standstill standstill) {
    const TyreCoefficients& p = tyre.parameters;
    const Relaxation relax = relaxation(p, motion, standstill);
    TyreState now = state;
    if (relax.length == 0) {
        const double speed = relax.speed(motion.Vx);
        now.kappa = -(motion.Vsx + state.du) / speed;                            // (20), (32)
        now.alpha = -(motion.Vsy + lateralSlope(p, motion) * state.dv) / speed;  // (19), (33)
    }
    const auto c = delft97::loadCoefficients(p, tyre.lambda, motion.Fz, motion.gamma);
    const auto f = delft97::horizontalForces(p, tyre.lambda, c, now.kappa, now.alpha);
    return rimForces(tyre, c, now, f, motion, relax);
}

TyreForces advance(TyreState& state, const TyreParams& tyre, const TyreMotion& begin, const TyreMotion& end, double dt,
                   Standstill standstill) {
    double Omega = 0;  // prescribed by the motion
    return refined(state, Omega, tyre, begin, end, dt, standstill,
                   [&](const TyreMotion& from, const TyreMotion& to, double h) {
                       return step(state, tyre, from, to, h, standstill);
                   });
}

TyreForces advance(TyreState& state, double& Omega, const TyreParams& tyre, const TyreMotion& begin,
                   const TyreMotion& end, const TyreSpin& spin, double dt, Standstill standstill) {
    return refined(state, Omega, tyre, begin, end, dt, standstill,
                   [&](const TyreMotion& from, const TyreMotion& to, double h) {
                       return step(state, Omega, tyre, from, to, spin, h, standstill);
                   });
}

}  // namespace tread
