// The contact-patch mass of Delft Tyre 97, (17)-(27), and the forces it passes to the wheel, in a second formulation to
// test the product's against. Source and axes: delft97_reference.h. Slip is the paper's alone, also at standstill.
#pragma once

#include <Eigen/Dense>
#include <algorithm>

#include "shared/delft97_reference.h"
#include "shared/transient_cases.h"

namespace reference {

using Vector2 = Eigen::Matrix<Real, 2, 1>;
using Matrix2 = Eigen::Matrix<Real, 2, 2>;

// Deflection (u, v) of the contact patch against the rim, and its rate.
struct Patch {
    Vector2 deflection = Vector2::Zero();
    Vector2 rate = Vector2::Zero();
};

// State and forces on the wheel at a sample. Where a case holds its samples, the forces are those at the end of the
// interval that leads to the sample, with what was held in it; the first point has the first sample's.
struct Point {
    Real t, u, v, du, dv, Fx, Fy, Mx, My, Mz;
};

// Everything that acts on the patch mass for one motion of the rim and one state of the patch.
struct PatchForces {
    Result contact;  // starred quantities
    Vector2 acceleration;
    Real Mzgyr;
};

inline PatchForces patchForces(const tread::TyreParams& tyre, const Sample& in, const Patch& patch) {
    const tread::TyreCoefficients& p = tyre.parameters;
    const Real u = patch.deflection[0], v = patch.deflection[1], du = patch.rate[0], dv = patch.rate[1];
    PatchForces out;
    out.Mzgyr = -Real(p.czgyr) * p.Ro * p.mt * in.Omega * dv;                       // (25)
    const Real psigyr = Real(p.cpsigyr) * out.Mzgyr / (Real(p.Ro) * p.Ro * p.cFy);  // (27)
    const Real Fygyr = Real(p.cygyr) * p.Ro * p.mt * in.Omega * in.psidot;          // (26)
    const Inputs rim{in.Fz, in.gamma, in.Vx, in.Vsx, in.Vsy};
    out.contact = contactPatch(p, tyre.lambda, rim, in.Vsx + du, in.Vsy + dv - in.Vx * psigyr);  // (19)
    const Real FyNL = std::max(in.Fz, 0.0L) * (p.pTy8 + p.pTy9 * out.contact.dfz) * in.gamma;    // (24)
    out.acceleration[0] = (out.contact.Fx - p.kFx * du - p.cFx * u) / p.mc;                      // (17)
    out.acceleration[1] = (out.contact.Fy - FyNL + Fygyr - p.kFy * dv - p.cFy * v) / p.mc;       // (18)
    return out;
}

inline Point wheelForces(const tread::TyreParams& tyre, const Sample& in, const Patch& patch) {
    const tread::TyreCoefficients& p = tyre.parameters;
    const PatchForces f = patchForces(tyre, in, patch);
    const Real Fz = std::max(in.Fz, 0.0L);
    Point point{};
    point.t = in.t;
    point.u = patch.deflection[0];
    point.v = patch.deflection[1];
    point.du = patch.rate[0];
    point.dv = patch.rate[1];
    point.Fx = f.contact.Fx - p.mc * f.acceleration[0];  // (21)
    point.Fy = f.contact.Fy - p.mc * f.acceleration[1];  // (22)
    point.Mz = f.contact.Mz + f.Mzgyr;                   // (23)
    // Couples of the wheel: forces of the wheel, without stars.
    point.Mx = overturningCouple(p, tyre.lambda, point.Fy, Fz, in.gamma);        // (84)
    point.My = rollingResistance(p, tyre.lambda, point.Fx, Fz, in.Vx - in.Vsx);  // (85)
    return point;
}

}  // namespace reference
