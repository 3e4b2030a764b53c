// Load between tyre and road (83): the tyre's radial spring and damper, and the rim when its side walls are folded.
#pragma once

#include <algorithm>

#include "tread/tyre.h"

namespace tread {

struct ForceAndSlope {
    double value;
    double slope;
};
// Nothing, then a parabola up to `width`, then a line: a contact without a kink.
inline ForceAndSlope onset(double x, double stiffness, double width) {
    if (x <= 0) return {0, 0};
    if (x < width) return {0.5 * stiffness * x * x / width, stiffness * x / width};
    return {stiffness * (x - 0.5 * width), stiffness};
}

// N/m
inline double radialStiffness(const TyreParams& tyre) {
    return tyre.parameters.pz1 * tyre.lambda.Cz;
}

struct TyreDeflection {
    double value;  // m
    double rate;   // m/s
    double fall;   // m/s, with which the wheel comes down on its rim: the rate, or for a wheel without mass, which
                   // stops at once, that of the body behind it
};

// Side walls are folded when the tyre has given way by this share of its radius; from there on the rim carries as well.
inline constexpr double kRimDeflection = 0.35;
ForceAndSlope rimForce(const TyreParams& tyre, const TyreDeflection& deflection);

// Normal to the road, not negative, and its slopes with deflection and deflection rate.
struct TyreLoad {
    double load;           // N
    double by_deflection;  // N/m
    double by_rate;        // N s/m
};
// `more` is a further damping force, N.
inline TyreLoad tyreLoad(const TyreParams& tyre, const TyreDeflection& deflection, double more = 0) {
    if (deflection.value <= 0) return {0, 0, 0};
    const double stiffness = radialStiffness(tyre);
    const double damping = tyre.parameters.pz2 * tyre.lambda.Kz;
    const double load = stiffness * deflection.value + damping * deflection.rate + more;  // (83)
    const TyreLoad soft = load > 0 ? TyreLoad{load, stiffness, damping} : TyreLoad{0, 0, 0};
    if (deflection.value <= kRimDeflection * tyre.parameters.Ro) return soft;
    const ForceAndSlope rim = rimForce(tyre, deflection);
    return {soft.load + rim.value, soft.by_deflection + rim.slope, soft.by_rate};
}

// The part of a load by which a tyre grips. The formulas are polynomials in the load, fitted to at most about twice the
// nominal one: what a landing brings beyond this many times that carries, but does not grip.
inline constexpr double kMostGripLoad = 4;
inline double grippingLoad(const TyreParams& tyre, double load) {
    return std::min(load, kMostGripLoad * tyre.parameters.Fzo * tyre.lambda.Fzo);
}

}  // namespace tread
