#include "tread/tyre_surroundings.h"

#include "base/math/elementary.h"
#include "vehicle/tyre_conditions.h"

namespace tread {
TyreParams inflated(TyreParams tyre, const TyrePressureParams& pressure) {
    const double p = (pressure.inflation - pressure.nominal) / pressure.nominal;
    if (p == 0) return tyre;
    tyre.lambda.Cz *= 1 + pressure.radial_stiffness * p;
    tyre.lambda.Kx *= 1 + pressure.slip_stiffness * p;
    tyre.lambda.Ky *= 1 + pressure.cornering_stiffness * p;
    // (53) with its peak at another load. pKy1 is the peak itself: 2 pKy1 / pKy2 is the slope at zero load.
    tyre.parameters.pKy2 *= 1 + pressure.cornering_peak_load * p;
    return tyre;
}

bool warms(const TyreTemperatureParams& params) {
    return params.heat_capacity > 0 || params.start != params.nominal;
}

bool feelsWarmth(const TyreTemperatureParams& params) {
    return warms(params) && (params.friction != 0 || params.friction_squared != 0 || params.stiffness != 0);
}

double advanceWarming(double warming, const TyreTemperatureParams& params, double slip_power, double speed, double dt) {
    return warmed(warming, params, slip_power, speed, dt);
}

TyreWarmth warmth(const TyreTemperatureParams& params, double warming) {
    const TyreFactors now = warmthOf(params, warming);
    return {.friction = now.friction, .stiffness = now.stiffness};
}

TyreShift shiftOf(const TyreSurroundingsParams& params, bool left) {
    // A wheel steered to the left slips to the right. Outwards is to the left (negative) on the left.
    return {.slip = tangent(params.ply_steer), .camber = left ? -params.conicity : params.conicity};
}

}  // namespace tread
