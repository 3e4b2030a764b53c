// Load between tyre and road (83): the tyre's radial spring and damper, and the rim when its side walls are folded.
// T is double, or lanes of which each holds another car; a tyre has its `parameters` and `lambda`.
#pragma once

#include <algorithm>

#include "base/math/lanes.h"
#include "tread/tyre.h"
#include "tyre/delft97.h"

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

// Side walls are folded when the tyre has given way by this share of its radius; from there on the rim carries as well.
inline constexpr double kRimDeflection = 0.35;
// `stiffness` is the radial one of the tyre, N/m, and `radius` its free one, m; the others as in BasicTyreDeflection.
ForceAndSlope rimForce(double stiffness, double radius, double deflection, double fall);

inline namespace TREAD_ISA {

// N/m
inline auto radialStiffness(const auto& tyre) {
    return tyre.parameters.pz1 * tyre.lambda.Cz;
}

template <class T>
struct BasicTyreDeflection {
    T value;  // m
    T rate;   // m/s
    T fall;   // m/s, with which the wheel comes down on its rim: the rate, or for a wheel without mass, which
              // stops at once, that of the body behind it
};
using TyreDeflection = BasicTyreDeflection<double>;

// Normal to the road, not negative, and its slopes with deflection and deflection rate.
template <class T>
struct BasicTyreLoad {
    T load;           // N
    T by_deflection;  // N/m
    T by_rate;        // N s/m
};
using TyreLoad = BasicTyreLoad<double>;

// `more` is a further damping force, N.
template <class T, class Tyre>
BasicTyreLoad<T> tyreLoad(const Tyre& tyre, const BasicTyreDeflection<T>& deflection, double more = 0) {
    const MaskOf<T> touches = !(deflection.value <= T(0));
    if (!any(touches)) return {0, 0, 0};
    const T stiffness = radialStiffness(tyre);
    const T damping = tyre.parameters.pz2 * tyre.lambda.Kz;
    const T load = stiffness * deflection.value + damping * deflection.rate + more;  // (83)
    const MaskOf<T> carries = touches & (load > T(0));
    BasicTyreLoad<T> total{select(carries, load, T(0)), select(carries, stiffness, T(0)),
                           select(carries, damping, T(0))};
    const MaskOf<T> folded = touches & (deflection.value > kRimDeflection * tyre.parameters.Ro);
    if (!any(folded)) return total;
    for (std::size_t i = 0; i < kLanesOf<T>; ++i) {
        if (!lane(folded, i)) continue;
        const ForceAndSlope rim = rimForce(lane(stiffness, i), lane(tyre.parameters.Ro, i), lane(deflection.value, i),
                                           lane(deflection.fall, i));
        setLane(total.load, i, lane(total.load, i) + rim.value);
        setLane(total.by_deflection, i, lane(total.by_deflection, i) + rim.slope);
    }
    return total;
}

// The part of a load by which a tyre grips. The formulas are polynomials in the load, fitted to at most about twice the
// nominal one: what a landing brings beyond this many times that carries, but does not grip.
inline constexpr double kMostGripLoad = 4;
template <class T, class Tyre>
T grippingLoad(const Tyre& tyre, const T& load) {
    return smaller(load, T(kMostGripLoad * tyre.parameters.Fzo * tyre.lambda.Fzo));
}

// Effective rolling radius under a load, m.
template <class T, class Tyre>
T rollingRadius(const Tyre& tyre, const T& load) {
    return delft97::rollingRadius(tyre.parameters, delft97::loadIncrement(tyre.parameters, tyre.lambda, load));
}

}  // namespace TREAD_ISA
}  // namespace tread
