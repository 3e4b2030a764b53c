// arctan, sine and cosine for the tyre's formulas: free of branches and calls, so that the dozen evaluations of one
// Magic Formula overlap in the processor, and the same bits on every machine (the C library picks its variant by CPU).
// Within 2 units in the last place for |x| < 1e5 (sine, cosine) and for every x (arctan).
//
// Approximations on the reduced range: S.L. Moshier, Cephes mathematical library, double precision atan and sin.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace tread {

inline double arctan(double x) {
    constexpr double kTan3Pi8 = 2.41421356237309504880;
    constexpr double kLowBits = 6.123233995736765886130e-17;  // of pi / 2
    const double a = std::abs(x);
    const bool large = a > kTan3Pi8;
    const bool middle = a > 0.66;
    // arctan a = pi/2 + arctan(-1/a), or pi/4 + arctan((a - 1)/(a + 1)), or itself.
    const double top = large ? -1.0 : (middle ? a - 1 : a);
    const double bottom = large ? a : (middle ? a + 1 : 1.0);
    const double offset = large ? std::numbers::pi / 2 : (middle ? std::numbers::pi / 4 : 0.0);
    const double low = large ? kLowBits : (middle ? 0.5 * kLowBits : 0.0);
    const double r = top / bottom;
    const double z = r * r;
    const double p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
                      1.228866684490136173410e2) * z - 6.485021904942025371773e1;
    const double q = ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z +
                       4.328810604912902668951e2) * z + 4.853903996359136964868e2) * z + 1.945506571482613964425e2;
    const double angle = offset + (r + (r * (z * p / q) + low));
    return std::copysign(angle, x);
}

struct SineCosine {
    double sine;
    double cosine;
};

inline SineCosine sineCosine(double x) {
    // x = n pi/2 + r with |r| <= pi/4; pi/2 in three parts whose products with n are exact.
    constexpr double kHalfPi1 = 2 * 7.85398125648498535156e-1;
    constexpr double kHalfPi2 = 2 * 3.77489470793079817668e-8;
    constexpr double kHalfPi3 = 2 * 2.69515142907905952645e-15;
    const double turns = x * (2 / std::numbers::pi);
    const auto n = static_cast<std::int64_t>(turns + std::copysign(0.5, turns));
    const auto nd = static_cast<double>(n);
    const double r = ((x - nd * kHalfPi1) - nd * kHalfPi2) - nd * kHalfPi3;
    const double z = r * r;
    const double s = r + r * z * (((((1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z +
                                     2.75573136213857245213e-6) * z - 1.98412698295895385996e-4) * z +
                                   8.33333333332211858878e-3) * z - 1.66666666666666307295e-1);
    const double c = 1 - 0.5 * z + z * z * (((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z -
                                               2.75573141792967388112e-7) * z + 2.48015872888517045348e-5) * z -
                                             1.38888888888730564116e-3) * z + 4.16666666666665929218e-2);
    const bool swap = (n & 1) != 0;
    const double sine = swap ? c : s;
    const double cosine = swap ? s : c;
    return {(n & 2) != 0 ? -sine : sine, ((n + 1) & 2) != 0 ? -cosine : cosine};
}

inline double sine(double x) { return sineCosine(x).sine; }
inline double cosine(double x) { return sineCosine(x).cosine; }

}  // namespace tread
