// A second formulation of Delft Tyre 97, steady state, to test the product's tyre against: written line by line from
// the paper, in long double, in the paper's axes (x forward, y right, z down), with nothing simplified and nothing
// shared.
//
// Source: H.B. Pacejka, I.J.M. Besselink, "Magic Formula Tyre Model with Transient Properties", Vehicle System Dynamics
// 27:S1 (1997) 234-249, equations (29)-(92). Where the paper leaves a choice, the line says which one is made.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tread/tyre.h"

namespace reference {

using Real = long double;

inline constexpr Real kEpsilonX = 0.01L;  // m/s, (31) and (34)

// Motion of the rim over the road, load and camber; Vsx = Vx - Re Omega.
struct Inputs {
    Real Fz = 0;
    Real gamma = 0;
    Real Vx = 0;
    Real Vsx = 0;
    Real Vsy = 0;
};

// Every quantity of the appendix under its own name; 0 behind a name marks pure slip, eq the equivalent slips (91),
// (92), at and ar are alpha_t and alpha_r, ay and kx are alpha_y and kappa_x, ca is c_alpha, ratio is Kx/Ky, Fyp is
// F'y.
struct Result {
    Real kappa, alpha, V, Vr, dfz, ca;
    Real SHx, SVx, kx, Cx, mux, Dx, Ex, Kx, Bx, Fx0;
    Real gy, Cy, muy, Dy, Ky, By, SHy, SVy, ay, Ey, Fy0;
    Real SHr, gz, Bt, Ct, Dt, SHt, at, ar, Et, Br, Dr, t0, Mzr0, Mz0;
    Real SHxa, Cxa, Bxa, Dxa, Gxa, Fx;
    Real SHyk, Cyk, Byk, Dyk, Gyk, DVyk, SVyk, Fy;
    Real Mx, My;
    Real ratio, ateq, areq, t, Fyp, Mzr, s, Mz;
};

inline Real sgn(Real x) {
    return x > 0 ? 1.0L : x < 0 ? -1.0L : 0.0L;
}
// (91), (92): with sgn(0) = 0 trail and residual torque would jump to their peak at the single point alpha_t = 0.
inline Real sgnOfSlip(Real x) {
    return x < 0 ? -1.0L : 1.0L;
}

// Rolling resistance torque (85); forces of the wheel, speed of rolling of the rim.
inline Real rollingResistance(const tread::TyreCoefficients& p, const tread::TyreScaling& l, Real Fx, Real Fz,
                              Real Vr) {
    return 2 / std::numbers::pi_v<Real> * (p.qy1 + p.qy2 * Fx) * Fz * std::atan(Vr) * l.My;
}

// Overturning couple (84).
inline Real overturningCouple(const tread::TyreCoefficients& p, const tread::TyreScaling& l, Real Fy, Real Fz,
                              Real gamma) {
    return (p.qx1 * Fy + p.qx2 * gamma) * Fz * l.Mx;
}

// Response of the contact patch to its own slip velocity (Vsx_patch, Vsy_patch) under a rim that moves with `in`.
inline Result contactPatch(const tread::TyreCoefficients& p, const tread::TyreScaling& l, const Inputs& in,
                           Real Vsx_patch, Real Vsy_patch) {
    using std::abs, std::atan, std::cos, std::exp, std::max, std::min, std::sin, std::sqrt;
    Result r{};
    const Real Fz = max(in.Fz, 0.0L);  // a lifted wheel has no load
    const Real gamma = in.gamma;

    // Slip of the contact patch
    const Real Fzo = p.Fzo;
    const Real Fzo_adapted = l.Fzo * Fzo;                // (29)
    r.dfz = (Fz - Fzo_adapted) / Fzo_adapted;            // (30)
    const Real Vx_limited = max(abs(in.Vx), kEpsilonX);  // (31)
    r.kappa = -Vsx_patch / Vx_limited;                   // (32)
    r.alpha = -Vsy_patch / Vx_limited;                   // (33)
    r.V = sqrt(in.Vx * in.Vx + in.Vsy * in.Vsy);         // of the wheel, not of the patch
    const Real V_limited = max(r.V, kEpsilonX);          // (34)
    r.ca = in.Vx / V_limited;                            // (35)
    r.Vr = in.Vx - in.Vsx;
    const Real dfz = r.dfz;

    // Longitudinal force at pure slip. Stiffnesses are also kept per load, since B, S_Hr and Kx/Ky have finite limits
    // at Fz = 0 where the printed quotients are 0/0.
    r.SHx = (p.pHx1 + p.pHx2 * dfz) * l.Hx;                                                            // (44)
    r.SVx = Fz * (p.pVx1 + p.pVx2 * dfz) * l.Vx * l.mux;                                               // (45)
    r.kx = r.kappa + r.SHx;                                                                            // (37)
    r.Cx = Real(p.pCx1) * l.Cx;                                                                        // (38)
    r.mux = max((p.pDx1 + p.pDx2 * dfz) * l.mux, 0.0L);                                                // (40)
    r.Dx = r.mux * Fz;                                                                                 // (39)
    r.Ex = min((p.pEx1 + p.pEx2 * dfz + p.pEx3 * dfz * dfz) * (1 - p.pEx4 * sgn(r.kx)) * l.Ex, 1.0L);  // (41)
    const Real Kx_per_load = (p.pKx1 + p.pKx2 * dfz) * exp(-p.pKx3 * dfz) * l.Kx;
    r.Kx = Fz * Kx_per_load;                                                                          // (42)
    r.Bx = r.mux > 0 ? Kx_per_load / (r.Cx * r.mux) : 0.0L;                                           // (43)
    r.Fx0 = r.Dx * sin(r.Cx * atan(r.Bx * r.kx - r.Ex * (r.Bx * r.kx - atan(r.Bx * r.kx)))) + r.SVx;  // (36)

    // Lateral force at pure slip
    r.gy = gamma * l.gy;                                                              // (48)
    r.Cy = Real(p.pCy1) * l.Cy;                                                       // (49)
    r.muy = max((p.pDy1 + p.pDy2 * dfz) * (1 - p.pDy3 * r.gy * r.gy) * l.muy, 0.0L);  // (51)
    r.Dy = r.muy * Fz;                                                                // (50)
    const Real Ky_camber = (1 - p.pKy3 * abs(r.gy)) * l.Ky;
    r.Ky = p.pKy1 * Fzo * sin(2 * atan(Fz / (p.pKy2 * Fzo * l.Fzo))) * Ky_camber * l.Fzo;  // (53)
    const Real Ky_per_load = Fz > 0 ? r.Ky / Fz : 2 * Real(p.pKy1) / p.pKy2 * Ky_camber;   // limit of (53)
    r.By = r.muy > 0 ? Ky_per_load / (r.Cy * r.muy) : 0.0L;                                // (54)
    r.SHy = (p.pHy1 + p.pHy2 * dfz + p.pHy3 * r.gy) * l.Hy;                                // (55)
    const Real SVy_per_load = (p.pVy1 + p.pVy2 * dfz + (p.pVy3 + p.pVy4 * dfz) * r.gy) * l.Vy * l.muy;
    r.SVy = Fz * SVy_per_load;                                                                        // (56)
    r.ay = r.alpha + r.SHy;                                                                           // (47)
    r.Ey = min((p.pEy1 + p.pEy2 * dfz) * (1 - (p.pEy3 + p.pEy4 * r.gy) * sgn(r.ay)) * l.Ey, 1.0L);    // (52)
    r.Fy0 = r.Dy * sin(r.Cy * atan(r.By * r.ay - r.Ey * (r.By * r.ay - atan(r.By * r.ay)))) + r.SVy;  // (46)

    // Aligning torque at pure slip
    r.SHr = r.SHy + SVy_per_load / Ky_per_load;  // (62)
    r.gz = gamma * l.gz;                         // (63)
    // Without friction Fy' and Dr are zero, and so is Mz whatever the slope factors: they are set to 0 as By is.
    const Real Ky_over_muy = l.muy > 0 ? Real(l.Ky) / l.muy : 0.0L;
    r.Bt = max((p.qBz1 + p.qBz2 * dfz + p.qBz3 * dfz * dfz) * (1 + p.qBz4 * r.gz + p.qBz5 * abs(r.gz)) * Ky_over_muy,
               0.0L);                                                                                       // (64)
    r.Ct = p.qCz1;                                                                                          // (65)
    r.Dt = Fz * (p.qDz1 + p.qDz2 * dfz) * (1 + p.qDz3 * r.gz + p.qDz4 * r.gz * r.gz) * (p.Ro / Fzo) * l.t;  // (66)
    r.SHt = p.qHz1 + p.qHz2 * dfz + (p.qHz3 + p.qHz4 * dfz) * r.gz;                                         // (68)
    r.at = r.alpha + r.SHt;                                                                                 // (59)
    r.ar = r.alpha + r.SHr;                                                                                 // (61)
    r.Et = min((p.qEz1 + p.qEz2 * dfz + p.qEz3 * dfz * dfz) * (1 + (p.qEz4 + p.qEz5 * r.gz) * atan(r.Bt * r.Ct * r.at)),
               1.0L);                                                                            // (67)
    r.Br = p.qBz9 * Ky_over_muy + p.qBz10 * r.By * r.Cy;                                         // (69)
    r.Dr = Fz * (p.qDz6 + p.qDz7 * dfz + (p.qDz8 + p.qDz9 * dfz) * r.gz) * p.Ro * l.Mr * l.muy;  // (70)
    const auto trail = [&](Real a) {
        return r.Dt * cos(r.Ct * atan(r.Bt * a - r.Et * (r.Bt * a - atan(r.Bt * a)))) * r.ca;  // (58), (87)
    };
    const auto residual = [&](Real a) { return r.Dr * cos(atan(r.Br * a)) * r.ca; };  // (60), (89)
    r.t0 = trail(r.at);
    r.Mzr0 = residual(r.ar);
    r.Mz0 = -r.t0 * r.Fy0 + r.Mzr0;  // (57)

    // Longitudinal force at combined slip
    r.SHxa = p.rHx1;                                      // (75)
    r.Cxa = p.rCx1;                                       // (73)
    r.Bxa = p.rBx1 * cos(atan(p.rBx2 * r.kappa)) * l.xa;  // (72)
    r.Dxa = r.Fx0 / cos(r.Cxa * atan(r.Bxa * r.SHxa));    // (74)
    r.Gxa = cos(r.Cxa * atan(r.Bxa * (r.alpha + r.SHxa))) / cos(r.Cxa * atan(r.Bxa * r.SHxa));
    r.Fx = r.Dxa * cos(r.Cxa * atan(r.Bxa * (r.alpha + r.SHxa)));  // (71)

    // Lateral force at combined slip
    r.SHyk = p.rHy1;                                                                               // (80)
    r.Cyk = p.rCy1;                                                                                // (78)
    r.Byk = p.rBy1 * cos(atan(p.rBy2 * (r.alpha - p.rBy3))) * l.yk;                                // (77)
    r.Dyk = r.Fy0 / cos(r.Cyk * atan(r.Byk * r.SHyk));                                             // (79)
    r.Gyk = cos(r.Cyk * atan(r.Byk * (r.kappa + r.SHyk))) / cos(r.Cyk * atan(r.Byk * r.SHyk));     // (12)
    r.DVyk = r.muy * Fz * (p.rVy1 + p.rVy2 * dfz + p.rVy3 * gamma) * cos(atan(p.rVy4 * r.alpha));  // (82)
    r.SVyk = r.DVyk * sin(p.rVy5 * atan(p.rVy6 * r.kappa)) * l.Vyk;                                // (81)
    r.Fy = r.Dyk * cos(r.Cyk * atan(r.Byk * (r.kappa + r.SHyk))) + r.SVyk;                         // (76)

    // Moments
    r.Mx = overturningCouple(p, l, r.Fy, Fz, gamma);  // (84)
    r.My = rollingResistance(p, l, r.Fx, Fz, r.Vr);   // (85)
    r.ratio = Kx_per_load / Ky_per_load;
    r.ateq = sqrt(r.at * r.at + r.ratio * r.ratio * r.kappa * r.kappa) * sgnOfSlip(r.at);  // (91)
    r.areq = sqrt(r.ar * r.ar + r.ratio * r.ratio * r.kappa * r.kappa) * sgnOfSlip(r.ar);  // (92)
    r.t = trail(r.ateq);
    r.Fyp = r.Fy - r.SVyk;  // (88)
    r.Mzr = residual(r.areq);
    r.s = (p.ssz1 + p.ssz2 * (r.Fy / Fzo) + (p.ssz3 + p.ssz4 * dfz) * gamma) * p.Ro * l.s;  // (90)
    r.Mz = -r.t * r.Fyp + r.Mzr + r.s * r.Fx;                                               // (86)
    return r;
}

// The steady state: the contact patch slips as the rim does.
inline Result steady(const tread::TyreCoefficients& p, const tread::TyreScaling& l, const Inputs& in) {
    return contactPatch(p, l, in, in.Vsx, in.Vsy);
}

}  // namespace reference
