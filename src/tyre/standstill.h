// The standstill extension: below walking speed the slip of the contact patch gets a relaxation of its own, so that a
// parked car holds. Above 2 m/s, and in paper mode, it is absent. T is double, or Lanes for four wheels at once.
#pragma once

#include <numbers>

#include "tyre/delft97.h"

namespace tread {
inline namespace TREAD_ISA {

// Speeds between which the extension fades out.
inline constexpr double kFullHoldSpeed = 1.0;  // m/s
inline constexpr double kNoHoldSpeed = 2.0;    // m/s
// Half the contact length over the chord that a circle of radius Ro cuts at the nominal deflection (a loaded tyre
// flattens over about half that chord).
inline constexpr double kContactLengthShare = 0.5;
// Loss of the carcass near standstill, as damping over stiffness: rubber loses about 15 % per radian at the 5 Hz at
// which a car rocks on its tyres. Without it a parked car would rock for minutes after each touch.
inline constexpr double kHysteresisTime = 0.005;  // s

template <class T>
struct Slip {
    T kappa = 0;
    T alpha = 0;
};

template <class T>
struct Relaxation {
    T length = 0;  // m, sigma_c faded by speed; 0: the paper's slip
    T weight = 0;  // 0: paper ... 1: full hold

    // |Vx|' of (31); in full hold the floor goes, or a held wheel would creep.
    T speed(const T& Vx) const { return larger(magnitude(Vx), T(delft97::kEpsX * (1 - weight))); }

    // Carcass damping (17), (18).
    T kFx(const BasicTyreCoefficients<T>& p) const { return p.kFx + weight * kHysteresisTime * p.cFx; }
    T kFy(const BasicTyreCoefficients<T>& p) const { return p.kFy + weight * kHysteresisTime * p.cFy; }
};

// What the extension fades with, m/s: the wheel's speed and slip velocity together.
template <class T>
T standstillSpeed(const BasicTyreMotion<T>& motion) {
    return squareRoot(T(motion.Vx * motion.Vx + motion.Vsx * motion.Vsx + motion.Vsy * motion.Vsy));
}

template <class T>
Relaxation<T> relaxation(const BasicTyreCoefficients<T>& p, const BasicTyreMotion<T>& motion, Standstill standstill) {
    if (standstill == Standstill::paper) return {};
    const T speed = standstillSpeed(motion);
    if (all(speed >= T(kNoHoldSpeed))) return {};
    const T x = larger(smaller(T((kNoHoldSpeed - speed) / (kNoHoldSpeed - kFullHoldSpeed)), T(1)), T(0));
    const T weight = x * x * (3 - 2 * x);
    const T half_length = kContactLengthShare * squareRoot(T(2 * p.Ro * p.Fzo / p.pz1));
    return {half_length * weight, weight};
}

// Slip at which a sine form has its peak: C arctan(x - E (x - arctan x)) = pi / 2.
template <class T>
T peakSlip(const T& B, const T& C, const T& E) {
    constexpr double kNoPeak = 5;  // x beyond which a curve with C <= 1 is flat
    constexpr int kIterations = 5;
    const auto quarter = sineCosine(T(std::numbers::pi / 2 / larger(C, T(1))));
    const T target = quarter.sine / quarter.cosine;
    T x = target;
    for (int i = 0; i < kIterations; ++i) {
        const T rest = x - E * (x - arctan(x)) - target;
        x = select(x < T(kNoPeak), T(x - rest / (1 - E + E / (1 + x * x))), x);
    }
    x = select((C > T(1)) & (x > T(0)) & (x < T(kNoPeak)), x, T(kNoPeak));
    return select(B > T(0), T(x / B), T(kNoPeak));
}

// The slip state must not wind up behind the force peak, or the patch would rebound over it when it lets go.
template <class T>
struct SlipLimit {
    T kappa_peak = 1;
    T alpha_peak = 1;
    T limit = kInfinity;  // in units of the peak slip
    bool limits = false;

    Slip<T> operator()(const Slip<T>& slip) const {
        if (!limits) return slip;
        const T x = slip.kappa / kappa_peak;
        const T y = slip.alpha / alpha_peak;
        const T size = squareRoot(T(x * x + y * y));
        const auto beyond = size > limit;
        return {select(beyond, T(slip.kappa * limit / size), slip.kappa),
                select(beyond, T(slip.alpha * limit / size), slip.alpha)};
    }
};

template <class T>
SlipLimit<T> slipLimit(const delft97::LoadCoefficients<T>& c, const T& weight) {
    if (all(weight == T(0))) return {};
    return {peakSlip(c.Bx, c.Cx, c.Ex_brake), peakSlip(c.By, c.Cy, c.Ey_positive),
            select(weight == T(0), T(kInfinity), T(1 / weight)), true};
}

}  // namespace TREAD_ISA
}  // namespace tread
