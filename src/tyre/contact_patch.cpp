#include "tyre/contact_patch.h"

namespace tread {

TyreForces rimForces(const TyreState& state, const TyreParams& tyre, const TyreMotion& motion, Standstill standstill) {
    const TyreCoefficients& p = tyre.parameters;
    const Relaxation<double> relax = relaxation(p, motion, standstill);
    TyreState now = state;
    if (relax.length == 0) {
        const double speed = relax.speed(motion.Vx);
        now.kappa = -(motion.Vsx + state.du) / speed;                            // (20), (32)
        now.alpha = -(motion.Vsy + lateralSlope(p, motion) * state.dv) / speed;  // (19), (33)
    }
    const auto c = delft97::loadCoefficients(p, tyre.lambda, motion.Fz, motion.gamma);
    const auto f = delft97::horizontalForces(p, tyre.lambda, c, now.kappa, now.alpha);
    return rimForces<double>({p, tyre.lambda}, c, now, f, motion, relax);
}

TyreForces advance(TyreState& state, const TyreParams& tyre, const TyreMotion& begin, const TyreMotion& end, double dt,
                   Standstill standstill) {
    double Omega = 0;  // prescribed by the motion
    return advance<double>(state, Omega, {tyre.parameters, tyre.lambda}, begin, end, GivenSpin<double>{}, dt,
                           standstill);
}

TyreForces advance(TyreState& state, double& Omega, const TyreParams& tyre, const TyreMotion& begin,
                   const TyreMotion& end, const TyreSpin& spin, double dt, Standstill standstill) {
    return advance<double>(state, Omega, {tyre.parameters, tyre.lambda}, begin, end, FreeSpin<double>{spin}, dt,
                           standstill);
}

}  // namespace tread
