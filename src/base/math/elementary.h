// Elementary functions over double or Lanes: free of branches and calls, so that the dozen evaluations of one Magic
// Formula overlap in the processor, and the same bits on every machine (the C library picks its variant by CPU and
// release). What computes a run uses these, and those of power.h, in place of the C library's. Square roots, roundings
// and remainders are exact everywhere and stay the library's.
//
// Largest errors, in units in the last place, as the test measures them:
//   arctan 1, arctan2 2, arcsine 2                for every x
//   sine, cosine 2, tangent 3.5                   for |x| < 8e8; sineCosineFar and tangentFar take any x
//   exponential, exponentialLess1 2               for |x| < 700; beyond it is held there
//   hyperbolicTangent 2, hypotenuse 1.5           for every x
//
// Approximations on the reduced range: S.L. Moshier, Cephes mathematical library, double precision atan, asin, sin, exp
// and tanh.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/math/lanes.h"

namespace tread {
inline namespace TREAD_ISA {

// arctan(y / x) of numbers that are not negative.
template <class T>
TREAD_INLINE inline T arctanOfQuotient(const T& y, const T& x) {
    constexpr double kTan3Pi8 = 2.41421356237309504880;
    constexpr double kLowBits = 6.123233995736765886130e-17;  // of pi / 2
    const auto large = y > T(kTan3Pi8 * x);
    const auto middle = y > T(0.66 * x);
    const auto pick = [&](const T& if_large, const T& if_middle, const T& otherwise) {
        return select(large, if_large, select(middle, if_middle, otherwise));
    };
    // arctan a = pi/2 + arctan(-1/a), or pi/4 + arctan((a - 1)/(a + 1)), or itself.
    const T top = pick(-x, y - x, y);
    const T bottom = pick(y, y + x, x);
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
    return offset + (r + (r * (z * p / q) + low));
}

template <class T>
TREAD_INLINE inline T arctan(const T& x) {
    return withSign(arctanOfQuotient(magnitude(x), T(1)), x);
}

// Angle of the vector (x, y), from -pi to pi; of (0, 0) and of infinities as the C library's.
template <class T>
TREAD_INLINE inline T arctan2(const T& y, const T& x) {
    constexpr double kPiLowBits = 1.2246467991473531772e-16;
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const T height = magnitude(y);
    const T width = magnitude(x);
    const T far = larger(height, width);
    const T near = select(far < T(0x1p-900), T(0x1p100), T(1));
    const T scale = select(far > T(0x1p1000), T(0x1p-100), near);  // sums shall not overflow, nor products vanish
    const auto nowhere = (height == T(0)) & (width == T(0));
    const auto endless = (height == T(kEndless)) & (width == T(kEndless));
    const T up = select(endless, T(1), T(scale * height));
    const T along = select(endless | nowhere, T(1), T(scale * width));
    const T angle = arctanOfQuotient(up, along);
    const auto behind = withSign(T(1), x) < T(0);
    return withSign(select(behind, T((std::numbers::pi - angle) + kPiLowBits), angle), y);
}

template <class T>
TREAD_INLINE inline T arcsine(const T& x) {
    constexpr double kLowBits = 6.123233995736765886130e-17;  // of pi / 2
    const T a = magnitude(x);
    const auto large = a > T(0.5);
    // arcsin a = pi/2 - 2 arcsin(sqrt((1 - a)/2)), or itself.
    const T z = select(large, T(0.5 * (1.0 - a)), T(a * a));
    const T r = select(large, squareRoot(z), a);
    const T p = ((((4.253011369004428248960e-3 * z - 6.019598008014123785661e-1) * z + 5.444622390564711410273e0) * z -
                  1.626247967210700244449e1) *
                     z +
                 1.956261983317594739197e1) *
                    z -
                8.198089802484824371615e0;
    const T q =
        ((((z - 1.474091372988853791896e1) * z + 7.049610280856842141659e1) * z - 1.471791292232726029859e2) * z +
         1.395105614657485689735e2) *
            z -
        4.918853881490881290097e1;
    const T small = r * (z * p / q);
    return withSign(select(large, T(std::numbers::pi / 2 - (2.0 * r + (2.0 * small - kLowBits))), T(r + small)), x);
}

// Sum modulo 2^64: of the bits of values that are no numbers, too.
template <class Bits>
TREAD_INLINE inline Bits wrappingSum(const Bits& a, const Bits& b) {
    if constexpr (std::is_same_v<Bits, std::int64_t>) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
    } else {
        typedef std::uint64_t Unsigned __attribute__((vector_size(sizeof(Bits))));
        return (Bits)((Unsigned)a + (Unsigned)b);
    }
}

// The integer nearest to x, |x| < 2^51, as a number and in the low bits of an integer: adding 1.5 * 2^52 rounds.
template <class T>
struct Nearest {
    explicit Nearest(const T& x) : Nearest(x, x + kShift) {}
    T value;
    BitsOf<T> bits;

    // The bits of the number after it.
    BitsOf<T> next() const { return wrappingSum<BitsOf<T>>(bits, BitsOf<T>{} + 1); }

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
    const auto c_sign = (n.next() << 62) & INT64_MIN;
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

template <class T>
T tangent(const T& x) {
    const SineCosine<T> both = sineCosine(x);
    return both.sine / both.cosine;
}

// Of angles of any size: beyond the range of sineCosine, a turn counts as the double nearest to 2 pi.
inline SineCosine<double> sineCosineFar(double x) {
    constexpr double kExact = 8e8;
    return sineCosine(std::abs(x) < kExact ? x : std::remainder(x, 2 * std::numbers::pi));
}
inline double tangentFar(double x) {
    const SineCosine<double> both = sineCosineFar(x);
    return both.sine / both.cosine;
}

// cos(arctan x), exact without trigonometry.
template <class T>
T cosArctan(const T& x) {
    return 1.0 / squareRoot(T(1.0 + x * x));
}

// e^r = 1 + 2 r p / (q - r p), with p and q in z = r^2.
inline constexpr double kExp[2][4] = {
    {9.99999999999999999910e-1, 3.02994407707441961300e-2, 1.26177193074810590878e-4, 0},
    {2.0, 2.27265548208155028766e-1, 2.52448340349684104192e-3, 3.00198505138664455042e-6}};
// x = n ln 2 + r, and the two polynomials.
template <class T>
struct ExponentialParts {
    TREAD_INLINE explicit ExponentialParts(const T& x, const Nearest<T>& n)
        : r((x - n.value * kLn2High) - n.value * kLn2Low),
          z(r * r),
          p(r * ((kExp[0][2] * z + kExp[0][1]) * z + kExp[0][0])),
          q(((kExp[1][3] * z + kExp[1][2]) * z + kExp[1][1]) * z + kExp[1][0]) {}
    T r, z, p, q;

private:
    static constexpr double kLn2High = 6.93145751953125e-1;
    static constexpr double kLn2Low = 1.42860682030941723212e-6;
};
// x 2^n
template <class T>
TREAD_INLINE inline T timesPowerOf2(const T& x, const Nearest<T>& n) {
    return std::bit_cast<T>(wrappingSum<BitsOf<T>>(std::bit_cast<BitsOf<T>>(x), n.bits << 52));
}
template <class T>
TREAD_INLINE inline T heldForExponential(const T& x) {
    constexpr double kLargest = 700;
    return larger(smaller(x, T(kLargest)), T(-kLargest));
}

template <class T>
T exponential(const T& exponent) {
    const T x = heldForExponential(exponent);
    const Nearest<T> n(x * std::numbers::log2e);
    const ExponentialParts<T> e(x, n);
    return timesPowerOf2(T(1.0 + 2.0 * (e.p / (e.q - e.p))), n);
}

// e^x - 1, exact also where x is small.
template <class T>
T exponentialLess1(const T& exponent) {
    const T x = heldForExponential(exponent);
    const auto small = magnitude(x) <= T(0.5);
    const Nearest<T> n(select(small, T(0), T(x * std::numbers::log2e)));
    const ExponentialParts<T> e(x, n);
    // e^r - 1 = r + r (r p + 2 p - q) / (q - r p), where 2 p - q begins with z.
    constexpr double k1 = 2 * kExp[0][1] - kExp[1][1], k2 = 2 * kExp[0][2] - kExp[1][2], k3 = -kExp[1][3];
    const T less1 = e.r + e.r * (e.p + e.z * ((k3 * e.z + k2) * e.z + k1)) / (e.q - e.p);
    const T scale = timesPowerOf2(T(1), n);
    return select(small, less1, T(scale * less1 + (scale - 1.0)));
}

template <class T>
T hyperbolicTangent(const T& x) {
    const T a = magnitude(x);
    const T z = x * x;
    const T p = (-9.64399179425052238628e-1 * z - 9.92877231001918586564e1) * z - 1.61468768441708447952e3;
    const T q = ((z + 1.12811678491632931402e2) * z + 2.23548839060100448583e3) * z + 4.84406305325125486048e3;
    const T small = a + a * (z * p / q);
    const T beyond = 1.0 - 2.0 / (exponential(T(2.0 * a)) + 1.0);
    return withSign(select(a < T(0.625), small, beyond), x);
}

// Length of the vector (x, y).
inline double hypotenuse(double x, double y) {
    const double far = larger(magnitude(x), magnitude(y));
    const double scale = far > 0x1p500 ? 0x1p-600 : far < 0x1p-500 ? 0x1p600 : 1;  // squares keep their digits
    const double a = scale * x, b = scale * y;
    return squareRoot(a * a + b * b) / scale;
}

}  // namespace TREAD_ISA
}  // namespace tread
