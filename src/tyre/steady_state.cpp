#include <algorithm>
#include <cmath>

#include "tread/tyre.h"
#include "tyre/delft97.h"

namespace tread {

TyreSteadyState steadyState(const TyreParams& tyre, const TyreSlip& slip) {
    const TyreCoefficients& p = tyre.parameters;
    const TyreScaling& l = tyre.lambda;
    const auto c = delft97::loadCoefficients(p, l, slip.Fz, slip.gamma);

    const double speed = std::max(std::abs(slip.Vx), delft97::kEpsX);  // (31)
    const double kappa = -slip.Vsx / speed;                            // (32)
    const double alpha = -slip.Vsy / speed;                            // (33)
    const auto f = delft97::horizontalForces(p, l, c, kappa, alpha);
    const double c_alpha = delft97::cosineOfSlipAngle(slip.Vx, slip.Vsy);
    const auto m = delft97::aligningTorque(p, l, c, kappa, alpha, f, c_alpha);

    return {.Fx = f.Fx,
            .Fy = f.Fy,
            .Mx = delft97::overturningCouple(p, l, c, f.Fy),
            .My = delft97::rollingResistanceTorque(p, l, c, f.Fx, slip.Vx - slip.Vsx),
            .Mz = m.Mz,
            .Fx0 = f.Fx0,
            .Fy0 = f.Fy0,
            .t = m.t,
            .Mzr = m.Mzr,
            .s = m.s,
            .Kx = c.Kx_Fz * c.Fz,
            .Ky = c.Ky_Fz * c.Fz,
            .mux = c.mux,
            .muy = c.muy,
            .SVyk = f.SVyk,
            .kappa = kappa,
            .alpha = alpha};
}

TyreParams mirrored(const TyreParams& tyre) {
    TyreParams other = tyre;
    other.side = tyre.side == TyreSide::left ? TyreSide::right : TyreSide::left;
    TyreCoefficients& p = other.parameters;
    for (double* coefficient : {&p.pEy3, &p.pHy1, &p.pHy2, &p.pVy1, &p.pVy2, &p.rBy3, &p.rHx1, &p.rVy1, &p.rVy2,
                                &p.qBz4, &p.qDz3, &p.qDz6, &p.qDz7, &p.qEz4, &p.qHz1, &p.qHz2, &p.ssz1}) {
        *coefficient = -*coefficient;
    }
    return other;
}

}  // namespace tread
