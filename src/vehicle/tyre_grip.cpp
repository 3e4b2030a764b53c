#include "vehicle/tyre_grip.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

// The carcass can hold what the road gives, and a little more while the patch swings.
constexpr double kCarcassExcess = 1.02;

double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

}  // namespace

double gripOf(const TyreParams& tyre, const TyreMotion& motion, double friction) {
    const TyreCoefficients& p = tyre.parameters;
    const TyreScaling& l = tyre.lambda;
    const double Fzo_ = l.Fzo * p.Fzo;                                                            // (29)
    const double dfz = (motion.Fz - Fzo_) / Fzo_;                                                 // (30)
    const double gy = motion.gamma * l.gy;                                                        // (48)
    const double mux = (p.pDx1 + p.pDx2 * dfz) * l.mux;                                           // (40)
    const double muy = (p.pDy1 + p.pDy2 * dfz) * (1 - p.pDy3 * gy * gy) * l.muy;                  // (51)
    const double SVx_Fz = (p.pVx1 + p.pVx2 * dfz) * l.Vx * l.mux;                                 // (45)
    const double SVy_Fz = (p.pVy1 + p.pVy2 * dfz + (p.pVy3 + p.pVy4 * dfz) * gy) * l.Vy * l.muy;  // (56)
    const double SVyk_Fz = muy * (p.rVy1 + p.rVy2 * dfz + p.rVy3 * motion.gamma) * l.Vyk;         // (81), (82)
    const double along = mux + std::abs(SVx_Fz);
    const double across = muy + std::abs(SVy_Fz) + std::abs(SVyk_Fz);
    return std::max({along, across, 0.0}) * friction * motion.Fz;
}

void limitToGrip(TyreState& state, TyreForces& forces, const TyreCoefficients& p, double grip) {
    const double most = kCarcassExcess * grip;
    const double stored = length(p.cFx * state.u, p.cFy * state.v);
    if (stored > most) {
        state.u *= most / stored;
        state.v *= most / stored;
    }
    const double force = length(forces.Fx, forces.Fy);
    if (force > most) {
        const double share = most / force;
        forces.Fx *= share;
        forces.Fy *= share;
        forces.Mz *= share;
    }
}

}  // namespace tread
