// arctan, sine, cosine and exp for the tyre's formulas, over double or Lanes: free of branches and calls, so that the
// dozen evaluations of one Magic Formula overlap in the processor, and the same bits on every machine (the C library
// picks its variant by CPU). Within 2 units in the last place for |x| < 1e5 (sine, cosine), for every x (arctan) and
// for |x| < 700 (exp; beyond it is held there).
//
// Approximations on the reduced range: S.L. Moshier, Cephes mathematical library, double precision atan, sin and exp.
#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

#include "tyre/lanes.h"

namespace tread {
inline namespace TREAD_ISA {

template <class T>
TREAD_INLINE inline T arctan(const T& x) {
    constexpr double kTan3Pi8 = 2.41421356237309504880;
    constexpr double kLowBits = 6.123233995736765886130e-17;  // of pi / 2
    const T a = magnitude(x);
    const auto large = a > T(kTan3Pi8);
    const auto middle = a > T(0.66);
    const auto pick = [&](const T& if_large, const T& if_middle, const T& otherwise) {
        return select(large, if_large, select(middle, if_middle, otherwise));
    };
    // arctan a = pi/2 + arctan(-1/a), or pi/4 + arctan((a - 1)/(a + 1)), or itself.
    const T top = pick(-1.0, a - 1.0, a);
    const T bottom = pick(a, a + 1.0, 1.0);
    const T offset = pick(std::numbers::pi / 2, std::numbers::pi / 4, 0.0);
    const T low = pick(kLowBits, 0.5 * kLowBits, 0.0);
    const T r = top / bottom;
    const T z = r * r;
    const T p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
                 1.228866684490136173410e2) *
                    z -
                6.485021904942025371773e1;
    const T q =
        ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2) * z +
         4.853903996359136964868e2) *
            z +
        1.945506571482613964425e2;
    return withSign(T(offset + (r + (r * (z * p / q) + low))), x);
}

// The integer nearest to x, |x| < 2^51, as a number and in the low bits of an integer: adding 1.5 * 2^52 rounds.
template <class T>
struct Nearest {
    explicit Nearest(const T& x) : Nearest(x, x + kShift) {}
    T value;
    BitsOf<T> bits;

private:
    static constexpr double kShift = 6755399441055744.0;
    Nearest(const T&, const T& shifted) : value(shifted - kShift), bits(std::bit_cast<BitsOf<T>>(shifted)) {}
};

template <class T>
struct SineCosine {
    T sine;
    T cosine;
};

template <class T>
SineCosine<T> sineCosine(const T& x) {
    // x = n pi/2 + r with |r| <= pi/4; pi/2 in three parts whose products with n are exact.
    constexpr double kHalfPi1 = 2 * 7.85398125648498535156e-1;
    constexpr double kHalfPi2 = 2 * 3.77489470793079817668e-8;
    constexpr double kHalfPi3 = 2 * 2.69515142907905952645e-15;
    const Nearest<T> n(x * (2 / std::numbers::pi));
    const T r = ((x - n.value * kHalfPi1) - n.value * kHalfPi2) - n.value * kHalfPi3;
    const T z = r * r;
    const T s =
        r + r * z *
                (((((1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z + 2.75573136213857245213e-6) * z -
                   1.98412698295895385996e-4) *
                      z +
                  8.33333333332211858878e-3) *
                     z -
                 1.66666666666666307295e-1);
    const T c =
        1.0 - 0.5 * z +
        z * z *
            (((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z - 2.75573141792967388112e-7) * z +
               2.48015872888517045348e-5) *
                  z -
              1.38888888888730564116e-3) *
                 z +
             4.16666666666665929218e-2);
    // Odd quarter turns swap the two; the second bit of n, and of n + 1, is the sign.
    const auto odd = -(n.bits & 1);
    const auto s_bits = std::bit_cast<BitsOf<T>>(s), c_bits = std::bit_cast<BitsOf<T>>(c);
    const auto sine = (s_bits & ~odd) | (c_bits & odd);
    const auto cosine = (c_bits & ~odd) | (s_bits & odd);
    const auto s_sign = (n.bits << 62) & INT64_MIN;
    const auto c_sign = ((n.bits + 1) << 62) & INT64_MIN;
    return {std::bit_cast<T>(sine ^ s_sign), std::bit_cast<T>(cosine ^ c_sign)};
}

template <class T>
T sine(const T& x) {
    return sineCosine(x).sine;
}
template <class T>
T cosine(const T& x) {
    return sineCosine(x).cosine;
}

// cos(arctan x), exact without trigonometry.
template <class T>
T cosArctan(const T& x) {
    return 1.0 / squareRoot(T(1.0 + x * x));
}

template <class T>
T exponential(const T& exponent) {
    constexpr double kLargest = 700;
    constexpr double kLn2High = 6.93145751953125e-1;
    constexpr double kLn2Low = 1.42860682030941723212e-6;
    const T x = larger(smaller(exponent, T(kLargest)), T(-kLargest));
    const Nearest<T> n(x * std::numbers::log2e);
    const T r = (x - n.value * kLn2High) - n.value * kLn2Low;
    const T z = r * r;
    const T p = r * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z + 9.99999999999999999910e-1);
    const T q = ((3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z + 2.27265548208155028766e-1) * z + 2.0;
    const T fraction = 1.0 + 2.0 * (p / (q - p));
    // times 2^n: added to the exponent's bits
    return std::bit_cast<T>(std::bit_cast<BitsOf<T>>(fraction) + (n.bits << 52));
}

}  // namespace TREAD_ISA
}  // namespace tread
