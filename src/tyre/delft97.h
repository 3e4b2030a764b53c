// Delft Tyre 97, steady state: equations (29)-(92) of H.B. Pacejka, I.J.M. Besselink, "Magic Formula Tyre Model with
// Transient Properties", Vehicle System Dynamics 27:S1 (1997) 234-249, in the paper's axes and symbols.
//
// Readings of what the paper leaves open: "(<= 1)" behind an E is min(E, 1); mu and Bt are not negative; at zero load
// the limit is taken (every B, shift and ratio is formed from stiffness over load, so nothing is divided by Fz);
// sgn(0) = +1. Helpers: cos(arctan x) = 1/sqrt(1 + x^2) and sin(2 arctan x) = 2x/(1 + x^2) are exact.
//
// The work is split by what changes how often: LoadCoefficients depend on load and camber, HorizontalForces on the
// slip as well (templates: also over Dual), moments are asked for once per step.
#pragma once

#include <algorithm>
#include <cmath>

#include "tread/tyre.h"
#include "tyre/dual.h"

namespace tread::delft97 {

inline constexpr double kEpsX = 0.01;  // m/s, lower bound of |Vx| and V (31), (34)
inline constexpr double kTwoOverPi = 0.63661977236758134308;

// All that depends on normal load and camber alone.
struct LoadCoefficients {
    double Fz, gamma, dfz;
    double SHx, SVx, Cx, mux, Dx, Kx_Fz, Bx, Ex_drive, Ex_brake;
    double SHy, SVy, Cy, muy, Dy, Ky_Fz, By, Ey_positive, Ey_negative;
    double DVyk_0;                                                                                  // (82) without its slip factor
};

inline double quotient(double numerator, double denominator) {
    return denominator == 0 ? 0 : numerator / denominator;
}

inline LoadCoefficients loadCoefficients(const TyreCoefficients& p, const TyreScaling& l, double load, double gamma) {
    LoadCoefficients c;
    const double Fzo_ = l.Fzo * p.Fzo;                                                              // (29)
    const double Fz = std::max(load, 0.0);
    const double dfz = (Fz - Fzo_) / Fzo_;                                                          // (30)
    c.Fz = Fz;
    c.gamma = gamma;
    c.dfz = dfz;

    c.Cx = p.pCx1 * l.Cx;                                                                           // (38)
    c.mux = std::max((p.pDx1 + p.pDx2 * dfz) * l.mux, 0.0);                                         // (40)
    c.Dx = c.mux * Fz;                                                                              // (39)
    const double Ex = (p.pEx1 + p.pEx2 * dfz + p.pEx3 * dfz * dfz) * l.Ex;                          // (41)
    c.Ex_drive = std::min(Ex * (1 - p.pEx4), 1.0);                                                  // (41)
    c.Ex_brake = std::min(Ex * (1 + p.pEx4), 1.0);                                                  // (41)
    c.Kx_Fz = (p.pKx1 + p.pKx2 * dfz) * std::exp(-p.pKx3 * dfz) * l.Kx;                             // (42)
    c.Bx = quotient(c.Kx_Fz, c.Cx * c.mux);                                                         // (43)
    c.SHx = (p.pHx1 + p.pHx2 * dfz) * l.Hx;                                                         // (44)
    c.SVx = Fz * (p.pVx1 + p.pVx2 * dfz) * l.Vx * l.mux;                                            // (45)

    const double gy = gamma * l.gy;                                                                 // (48)
    c.Cy = p.pCy1 * l.Cy;                                                                           // (49)
    c.muy = std::max((p.pDy1 + p.pDy2 * dfz) * (1 - p.pDy3 * gy * gy) * l.muy, 0.0);                // (51)
    c.Dy = c.muy * Fz;                                                                              // (50)
    const double Ey = (p.pEy1 + p.pEy2 * dfz) * l.Ey;                                               // (52)
    c.Ey_positive = std::min(Ey * (1 - (p.pEy3 + p.pEy4 * gy)), 1.0);                               // (52)
    c.Ey_negative = std::min(Ey * (1 + (p.pEy3 + p.pEy4 * gy)), 1.0);                               // (52)
    const double x = Fz / (p.pKy2 * Fzo_);
    c.Ky_Fz = 2 * p.pKy1 / p.pKy2 / (1 + x * x) * (1 - p.pKy3 * std::abs(gy)) * l.Ky;               // (53)
    c.By = quotient(c.Ky_Fz, c.Cy * c.muy);                                                         // (54)
    c.SHy = (p.pHy1 + p.pHy2 * dfz + p.pHy3 * gy) * l.Hy;                                           // (55)
    c.SVy = Fz * (p.pVy1 + p.pVy2 * dfz + (p.pVy3 + p.pVy4 * dfz) * gy) * l.Vy * l.muy;             // (56)

    c.DVyk_0 = c.muy * Fz * (p.rVy1 + p.rVy2 * dfz + p.rVy3 * gamma);                               // (82)
    return c;
}

// D sin[C arctan{x - E (x - arctan x)}] with x = B times slip: (36), (46).
template <class T>
T sineForm(double D, double C, const T& x, double E) {
    return D * sine(C * arctan(x - E * (x - arctan(x))));
}

// cos[C arctan{B (slip + S)}] / cos[C arctan(B S)]: the hill that weighs one force by the other slip (71), (76).
template <class T>
T weighting(double C, const T& B, const T& slip, double S) {
    return cosine(C * arctan(B * (slip + S))) / cosine(C * arctan(B * S));
}

template <class T>
struct HorizontalForces {
    T Fx, Fy;         // at combined slip
    T Fx0, Fy0;       // at pure slip
    T SVyk;           // slip-induced ply-steer
};

template <class T>
HorizontalForces<T> horizontalForces(const TyreCoefficients& p, const TyreScaling& l, const LoadCoefficients& c,
                                     const T& kappa, const T& alpha) {
    HorizontalForces<T> f;
    const T kappa_x = kappa + c.SHx;                                                                // (37)
    const double Ex = valueOf(kappa_x) >= 0 ? c.Ex_drive : c.Ex_brake;                              // (41)
    f.Fx0 = sineForm(c.Dx, c.Cx, c.Bx * kappa_x, Ex) + c.SVx;                                       // (36)

    const T alpha_y = alpha + c.SHy;                                                                // (47)
    const double Ey = valueOf(alpha_y) >= 0 ? c.Ey_positive : c.Ey_negative;                        // (52)
    f.Fy0 = sineForm(c.Dy, c.Cy, c.By * alpha_y, Ey) + c.SVy;                                       // (46)

    const T Bxa = p.rBx1 * l.xa * cosArctan(p.rBx2 * kappa);                                        // (72)
    f.Fx = f.Fx0 * weighting(p.rCx1, Bxa, alpha, p.rHx1);                                           // (71), (74)

    const T Byk = p.rBy1 * l.yk * cosArctan(p.rBy2 * (alpha - p.rBy3));                             // (77)
    const T DVyk = c.DVyk_0 * cosArctan(p.rVy4 * alpha);                                            // (82)
    f.SVyk = l.Vyk * DVyk * sine(p.rVy5 * arctan(p.rVy6 * kappa));                                  // (81)
    f.Fy = f.Fy0 * weighting(p.rCy1, Byk, kappa, p.rHy1) + f.SVyk;                                  // (76), (79)
    return f;
}

// c_alpha: cosine of the slip angle of the wheel, protected against standstill.
inline double cosineOfSlipAngle(double Vx, double Vsy) {
    return Vx / std::max(std::sqrt(Vx * Vx + Vsy * Vsy), kEpsX);                                    // (34), (35)
}

struct AligningTorque {
    double Mz, t, Mzr, s;
};

inline AligningTorque aligningTorque(const TyreCoefficients& p, const TyreScaling& l, const LoadCoefficients& c,
                                     double kappa, double alpha, const HorizontalForces<double>& f, double c_alpha) {
    const double dfz = c.dfz;
    const double gamma_z = c.gamma * l.gz;                                                          // (63)
    const double stiffening = quotient(l.Ky, l.muy);
    const double Bt = std::max((p.qBz1 + p.qBz2 * dfz + p.qBz3 * dfz * dfz) *
                               (1 + p.qBz4 * gamma_z + p.qBz5 * std::abs(gamma_z)) * stiffening, 0.0);  // (64)
    const double Ct = p.qCz1;                                                                       // (65)
    const double Dt = c.Fz * (p.qDz1 + p.qDz2 * dfz) * (1 + p.qDz3 * gamma_z + p.qDz4 * gamma_z * gamma_z) *
                      (p.Ro / p.Fzo) * l.t;                                                         // (66)
    const double SHt = p.qHz1 + p.qHz2 * dfz + (p.qHz3 + p.qHz4 * dfz) * gamma_z;                   // (68)
    const double Br = p.qBz9 * stiffening + p.qBz10 * c.By * c.Cy;                                  // (69)
    const double Dr = c.Fz * (p.qDz6 + p.qDz7 * dfz + (p.qDz8 + p.qDz9 * dfz) * gamma_z) * p.Ro *
                      l.Mr * l.muy;                                                                 // (70)
    const double alpha_t = alpha + SHt;                                                             // (59)
    const double SVy_Fz = (p.pVy1 + p.pVy2 * dfz + (p.pVy3 + p.pVy4 * dfz) * c.gamma * l.gy) * l.Vy * l.muy;
    const double SHr = c.SHy + quotient(SVy_Fz, c.Ky_Fz);                                           // (62)
    const double alpha_r = alpha + SHr;                                                             // (61)
    const double Et = std::min((p.qEz1 + p.qEz2 * dfz + p.qEz3 * dfz * dfz) *
                               (1 + (p.qEz4 + p.qEz5 * gamma_z) * arctan(Bt * Ct * alpha_t)), 1.0);  // (67)

    const double kappa_y = quotient(c.Kx_Fz, c.Ky_Fz) * kappa;
    const double alpha_teq = std::sqrt(alpha_t * alpha_t + kappa_y * kappa_y) * (alpha_t >= 0 ? 1 : -1);  // (91)
    const double alpha_req = std::sqrt(alpha_r * alpha_r + kappa_y * kappa_y);                      // (92), even in (89)

    AligningTorque m;
    const double x = Bt * alpha_teq;
    m.t = Dt * cosine(Ct * arctan(x - Et * (x - arctan(x)))) * c_alpha;                             // (87)
    m.Mzr = Dr * cosArctan(Br * alpha_req) * c_alpha;                                               // (89)
    m.s = (p.ssz1 + p.ssz2 * f.Fy / p.Fzo + (p.ssz3 + p.ssz4 * dfz) * c.gamma) * p.Ro * l.s;        // (90)
    m.Mz = -m.t * (f.Fy - f.SVyk) + m.Mzr + m.s * f.Fx;                                             // (86), (88)
    return m;
}

inline double overturningCouple(const TyreCoefficients& p, const TyreScaling& l, const LoadCoefficients& c, double Fy) {
    return (p.qx1 * Fy + p.qx2 * c.gamma) * c.Fz * l.Mx;                                            // (84)
}

inline double rollingResistanceTorque(const TyreCoefficients& p, const TyreScaling& l, const LoadCoefficients& c,
                                      double Fx, double Vr) {
    return kTwoOverPi * (p.qy1 + p.qy2 * Fx) * c.Fz * arctan(Vr) * l.My;                            // (85)
}

}  // namespace tread::delft97
