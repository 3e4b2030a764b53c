// Delft Tyre 97, steady state: equations (29)-(92) of H.B. Pacejka, I.J.M. Besselink, "Magic Formula Tyre Model with
// Transient Properties", Vehicle System Dynamics 27:S1 (1997) 234-249, in the paper's axes and symbols.
//
// Readings of what the paper leaves open: "(<= 1)" behind an E is min(E, 1); mu and Bt are not negative; at zero load
// the limit is taken (every B, shift and ratio is formed from stiffness over load, so nothing is divided by Fz);
// sgn(0) = +1. Helpers: cos(arctan x) = 1/sqrt(1 + x^2) and sin(2 arctan x) = 2x/(1 + x^2) are exact.
//
// The work is split by what changes how often: LoadCoefficients depend on load and camber, HorizontalForces on the
// slip as well, moments are asked for once per step. T is double, or Lanes for four wheels at once; S, the type of the
// slip, is T or Dual<T>.
#pragma once

#include "base/math/lanes.h"
#include "tread/tyre.h"
#include "tyre/dual.h"

namespace tread {
inline namespace TREAD_ISA {
namespace delft97 {

inline constexpr double kEpsX = 0.01;  // m/s, lower bound of |Vx| and V (31), (34)
inline constexpr double kTwoOverPi = 0.63661977236758134308;

// All that depends on normal load and camber alone.
template <class T>
struct LoadCoefficients {
    T Fz, gamma, dfz, Re;
    T SHx, SVx, Cx, mux, Dx, Kx_Fz, Bx, Ex_drive, Ex_brake;
    T SHy, SVy, Cy, muy, Dy, Ky_Fz, By, Ey_positive, Ey_negative;
    T DVyk_0;  // (82) without its slip factor
};

template <class T>
T quotient(const T& numerator, const T& denominator) {
    return select(denominator == T(0), T(0), numerator / denominator);
}

// Load over the nominal one, less one.
template <class T>
T loadIncrement(const BasicTyreCoefficients<T>& p, const BasicTyreScaling<T>& l, const T& Fz) {
    const T Fzo_ = l.Fzo * p.Fzo;  // (29)
    return (Fz - Fzo_) / Fzo_;     // (30)
}

// Effective rolling radius, m: constant in the paper, here linear in the load, as MF-Tyre's is about the nominal load.
template <class T>
T rollingRadius(const BasicTyreCoefficients<T>& p, const T& dfz) {
    return p.Re * (1 + p.pRe1 * dfz);
}

template <class T>
LoadCoefficients<T> loadCoefficients(const BasicTyreCoefficients<T>& p, const BasicTyreScaling<T>& l, const T& load,
                                     const T& gamma) {
    LoadCoefficients<T> c;
    const T Fz = larger(load, T(0));
    const T dfz = loadIncrement(p, l, Fz);
    c.Fz = Fz;
    c.gamma = gamma;
    c.dfz = dfz;
    c.Re = rollingRadius(p, dfz);

    c.Cx = p.pCx1 * l.Cx;                                                      // (38)
    c.mux = larger<T>((p.pDx1 + p.pDx2 * dfz) * l.mux, 0.0);                   // (40)
    c.Dx = c.mux * Fz;                                                         // (39)
    const T Ex = (p.pEx1 + p.pEx2 * dfz + p.pEx3 * dfz * dfz) * l.Ex;          // (41)
    c.Ex_drive = smaller<T>(Ex * (1 - p.pEx4), 1.0);                           // (41)
    c.Ex_brake = smaller<T>(Ex * (1 + p.pEx4), 1.0);                           // (41)
    c.Kx_Fz = (p.pKx1 + p.pKx2 * dfz) * exponential(T(-p.pKx3 * dfz)) * l.Kx;  // (42)
    c.Bx = quotient(c.Kx_Fz, c.Cx * c.mux);                                    // (43)
    c.SHx = (p.pHx1 + p.pHx2 * dfz) * l.Hx;                                    // (44)
    c.SVx = Fz * (p.pVx1 + p.pVx2 * dfz) * l.Vx * l.mux;                       // (45)

    const T gy = gamma * l.gy;                                                         // (48)
    c.Cy = p.pCy1 * l.Cy;                                                              // (49)
    c.muy = larger<T>((p.pDy1 + p.pDy2 * dfz) * (1 - p.pDy3 * gy * gy) * l.muy, 0.0);  // (51)
    c.Dy = c.muy * Fz;                                                                 // (50)
    const T Ey = (p.pEy1 + p.pEy2 * dfz) * l.Ey;                                       // (52)
    c.Ey_positive = smaller<T>(Ey * (1 - (p.pEy3 + p.pEy4 * gy)), 1.0);                // (52)
    c.Ey_negative = smaller<T>(Ey * (1 + (p.pEy3 + p.pEy4 * gy)), 1.0);                // (52)
    const T x = Fz / (p.pKy2 * (l.Fzo * p.Fzo));
    c.Ky_Fz = 2 * p.pKy1 / p.pKy2 / (1 + x * x) * (1 - p.pKy3 * magnitude(gy)) * l.Ky;   // (53)
    c.By = quotient(c.Ky_Fz, c.Cy * c.muy);                                              // (54)
    c.SHy = (p.pHy1 + p.pHy2 * dfz + p.pHy3 * gy) * l.Hy;                                // (55)
    c.SVy = Fz * (p.pVy1 + p.pVy2 * dfz + (p.pVy3 + p.pVy4 * dfz) * gy) * l.Vy * l.muy;  // (56)

    c.DVyk_0 = c.muy * Fz * (p.rVy1 + p.rVy2 * dfz + p.rVy3 * gamma);  // (82)
    return c;
}

// The formulas are long chains in which each operation waits for the one before. Two that do not need each other are
// therefore computed step by step beside each other: that takes little longer than one.
template <class S>
struct Two {
    S x, y;
};

// D sin[C arctan{x - E (x - arctan x)}] with x = B times slip: (36), (46).
template <class T, class S>
struct SineForm {
    const T &D, &C;
    S x;
    const T& E;
};

template <class T, class S>
Two<S> sineForms(const SineForm<T, S>& a, const SineForm<T, S>& b) {
    const S a1 = arctan(a.x), b1 = arctan(b.x);
    const S a2 = arctan(a.x - a.E * (a.x - a1)), b2 = arctan(b.x - b.E * (b.x - b1));
    return {a.D * sine(a.C * a2), b.D * sine(b.C * b2)};
}

// cos[C arctan{B (slip + S)}] / cos[C arctan(B S)]: the hill that weighs one force by the other slip (71), (76).
template <class T, class S>
struct Weighting {
    const T& C;
    S B;
    const S& slip;
    const T& shift;
};

template <class T, class S>
Two<S> weightings(const Weighting<T, S>& a, const Weighting<T, S>& b) {
    const S a1 = arctan(a.B * (a.slip + a.shift)), b1 = arctan(b.B * (b.slip + b.shift));
    const S a0 = arctan(a.shift * a.B), b0 = arctan(b.shift * b.B);
    return {cosine(a.C * a1) / cosine(a.C * a0), cosine(b.C * b1) / cosine(b.C * b0)};
}

template <class S>
struct HorizontalForces {
    S Fx, Fy;    // at combined slip
    S Fx0, Fy0;  // at pure slip
    S SVyk;      // slip-induced ply-steer
};

template <class T, class S>
HorizontalForces<S> horizontalForces(const BasicTyreCoefficients<T>& p, const BasicTyreScaling<T>& l,
                                     const LoadCoefficients<T>& c, const S& kappa, const S& alpha) {
    HorizontalForces<S> f;
    const S kappa_x = kappa + c.SHx;                                              // (37)
    const T Ex = select(valueOf(kappa_x) >= T(0), c.Ex_drive, c.Ex_brake);        // (41)
    const S alpha_y = alpha + c.SHy;                                              // (47)
    const T Ey = select(valueOf(alpha_y) >= T(0), c.Ey_positive, c.Ey_negative);  // (52)
    const Two<S> pure = sineForms<T, S>({c.Dx, c.Cx, c.Bx * kappa_x, Ex}, {c.Dy, c.Cy, c.By * alpha_y, Ey});
    f.Fx0 = pure.x + c.SVx;  // (36)
    f.Fy0 = pure.y + c.SVy;  // (46)

    const S Bxa = p.rBx1 * l.xa * cosArctan(p.rBx2 * kappa);             // (72)
    const S Byk = p.rBy1 * l.yk * cosArctan(p.rBy2 * (alpha - p.rBy3));  // (77)
    const Two<S> weight = weightings<T, S>({p.rCx1, Bxa, alpha, p.rHx1}, {p.rCy1, Byk, kappa, p.rHy1});
    f.Fx = f.Fx0 * weight.x;  // (71), (74)

    const S DVyk = c.DVyk_0 * cosArctan(p.rVy4 * alpha);            // (82)
    f.SVyk = l.Vyk * DVyk * sine(p.rVy5 * arctan(p.rVy6 * kappa));  // (81)
    f.Fy = f.Fy0 * weight.y + f.SVyk;                               // (76), (79)
    return f;
}

// c_alpha: cosine of the slip angle of the wheel, protected against standstill.
template <class T>
T cosineOfSlipAngle(const T& Vx, const T& Vsy) {
    return Vx / larger(squareRoot(T(Vx * Vx + Vsy * Vsy)), T(kEpsX));  // (34), (35)
}

template <class T>
struct AligningTorque {
    T Mz, t, Mzr, s;
};

template <class T>
AligningTorque<T> aligningTorque(const BasicTyreCoefficients<T>& p, const BasicTyreScaling<T>& l,
                                 const LoadCoefficients<T>& c, const T& kappa, const T& alpha,
                                 const HorizontalForces<T>& f, const T& c_alpha) {
    const T dfz = c.dfz;
    const T gamma_z = c.gamma * l.gz;  // (63)
    const T stiffening = quotient(l.Ky, l.muy);
    const T Bt = larger<T>((p.qBz1 + p.qBz2 * dfz + p.qBz3 * dfz * dfz) *
                               (1 + p.qBz4 * gamma_z + p.qBz5 * magnitude(gamma_z)) * stiffening,
                           0.0);  // (64)
    const T Ct = p.qCz1;          // (65)
    const T Dt = c.Fz * (p.qDz1 + p.qDz2 * dfz) * (1 + p.qDz3 * gamma_z + p.qDz4 * gamma_z * gamma_z) * (p.Ro / p.Fzo) *
                 l.t;                                                                                       // (66)
    const T SHt = p.qHz1 + p.qHz2 * dfz + (p.qHz3 + p.qHz4 * dfz) * gamma_z;                                // (68)
    const T Br = p.qBz9 * stiffening + p.qBz10 * c.By * c.Cy;                                               // (69)
    const T Dr = c.Fz * (p.qDz6 + p.qDz7 * dfz + (p.qDz8 + p.qDz9 * dfz) * gamma_z) * p.Ro * l.Mr * l.muy;  // (70)
    const T alpha_t = alpha + SHt;                                                                          // (59)
    const T SVy_Fz = (p.pVy1 + p.pVy2 * dfz + (p.pVy3 + p.pVy4 * dfz) * c.gamma * l.gy) * l.Vy * l.muy;
    const T SHr = c.SHy + quotient(SVy_Fz, c.Ky_Fz);  // (62)
    const T alpha_r = alpha + SHr;                    // (61)
    const T Et = smaller<T>(
        (p.qEz1 + p.qEz2 * dfz + p.qEz3 * dfz * dfz) * (1 + (p.qEz4 + p.qEz5 * gamma_z) * arctan(Bt * Ct * alpha_t)),
        1.0);  // (67)

    const T kappa_y = quotient(c.Kx_Fz, c.Ky_Fz) * kappa;
    const T alpha_teq =
        squareRoot(T(alpha_t * alpha_t + kappa_y * kappa_y)) * select(alpha_t >= T(0), T(1), T(-1));  // (91)
    const T alpha_req = squareRoot(T(alpha_r * alpha_r + kappa_y * kappa_y));  // (92), even in (89)

    AligningTorque<T> m;
    const T x = Bt * alpha_teq;
    m.t = Dt * cosine(Ct * arctan(x - Et * (x - arctan(x)))) * c_alpha;                       // (87)
    m.Mzr = Dr * cosArctan(Br * alpha_req) * c_alpha;                                         // (89)
    m.s = (p.ssz1 + p.ssz2 * f.Fy / p.Fzo + (p.ssz3 + p.ssz4 * dfz) * c.gamma) * p.Ro * l.s;  // (90)
    m.Mz = -m.t * (f.Fy - f.SVyk) + m.Mzr + m.s * f.Fx;                                       // (86), (88)
    return m;
}

template <class T>
T overturningCouple(const BasicTyreCoefficients<T>& p, const BasicTyreScaling<T>& l, const LoadCoefficients<T>& c,
                    const T& Fy) {
    return (p.qx1 * Fy + p.qx2 * c.gamma) * c.Fz * l.Mx;  // (84)
}

template <class T>
T rollingResistanceTorque(const BasicTyreCoefficients<T>& p, const BasicTyreScaling<T>& l, const LoadCoefficients<T>& c,
                          const T& Fx, const T& Vr) {
    return kTwoOverPi * (p.qy1 + p.qy2 * Fx) * c.Fz * arctan(Vr) * l.My;  // (85)
}

}  // namespace delft97
}  // namespace TREAD_ISA
}  // namespace tread
