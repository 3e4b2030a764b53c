// The logarithm is computed in two doubles, of which the second continues the first, by
//     log m = 2 (s + s^3/3 + s^5/5 + ...),   s = (m - 1) / (m + 1),   1/sqrt 2 <= m < sqrt 2.
// A power multiplies an error of the logarithm by up to 745.
//
// Sums and products in two doubles: T.J. Dekker, A floating-point technique for extending the available precision,
// Numerische Mathematik 18, 1971.
#include "base/math/power.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace tread {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// ln 2 in two parts; products of the first with exponents are exact.
constexpr double kLn2High = 0x1.62e42feep-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

// high + low, where low is the rounding of high.
struct TwoDoubles {
    double high;
    double low;
};

TwoDoubles sum(double a, double b) {
    const double high = a + b, taken = high - a;
    return {high, (a - (high - taken)) + (b - taken)};
}

TwoDoubles halves(double a) {
    const double shifted = (0x1p27 + 1) * a, high = shifted - (shifted - a);
    return {high, a - high};
}

TwoDoubles product(double a, double b) {
    const double high = a * b;
    const TwoDoubles x = halves(a), y = halves(b);
    return {high, ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

TwoDoubles times(const TwoDoubles& a, const TwoDoubles& b) {
    const TwoDoubles p = product(a.high, b.high);
    return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

TwoDoubles quotient(const TwoDoubles& a, const TwoDoubles& b) {
    const double first = a.high / b.high;
    const TwoDoubles p = product(first, b.high);
    return sum(first, (((a.high - p.high) - p.low) + a.low - first * b.low) / b.high);
}

// Of a positive finite number.
TwoDoubles logarithmInTwo(double x) {
    // x = m 2^n
    const double lift = x < std::numeric_limits<double>::min() ? 54 : 0;
    const auto bits = std::bit_cast<std::int64_t>(lift > 0 ? x * 0x1p54 : x);
    constexpr auto kRootHalf = std::bit_cast<std::int64_t>(0.5 * std::numbers::sqrt2);
    const std::int64_t n = (bits - kRootHalf) >> 52;
    const auto m = std::bit_cast<double>(bits - (n << 52));

    const TwoDoubles s = quotient({m - 1, 0}, sum(m, 1));
    const TwoDoubles z = times(s, s);
    // 1/5 + z/7 + ...: 0.0295^9 is below a rounding of the sum 1 + z/3 + z^2 (1/5 + ...).
    double tail = 0;
    for (int k = 23; k >= 5; k -= 2) tail = tail * z.high + 1.0 / k;
    const TwoDoubles third = quotient(z, {3, 0});
    const TwoDoubles series = sum(third.high, third.low + z.high * z.high * tail);
    const TwoDoubles rest = times(s, series);

    const double turns = static_cast<double>(n) - lift;
    const TwoDoubles whole = sum(turns * kLn2High, 2 * s.high);
    const TwoDoubles more = sum(whole.high, 2 * rest.high);
    return sum(more.high, more.low + (whole.low + (2 * rest.low + (2 * s.low + turns * kLn2Low))));
}

// e^(high + low), for what is not far beyond the largest and the smallest number.
double exponentialOf(const TwoDoubles& x) {
    const double n = std::round(x.high * std::numbers::log2e);
    const TwoDoubles r = sum(x.high - n * kLn2High, x.low - n * kLn2Low);
    // 1/2 + r/6 + ... + r^11/13!
    static constexpr auto kFactorials = [] {
        std::array<double, 14> all{1};
        for (std::size_t k = 1; k < all.size(); ++k) all[k] = static_cast<double>(k) * all[k - 1];
        return all;
    }();
    double tail = 0;
    for (std::size_t k = kFactorials.size() - 1; k >= 2; --k) tail = tail * r.high + 1 / kFactorials[k];
    const double less1 = r.high + (r.high * r.high * tail + r.low);
    return std::ldexp(1 + less1, static_cast<int>(n));
}

bool isWhole(double x) {
    return x == std::floor(x);
}
bool isOdd(double x) {
    return isWhole(x) && !isWhole(0.5 * x);
}

// Where base or exponent is 0 or infinite; of the base, its size.
double powerAtEnd(double size, double exponent) {
    if (std::isinf(exponent)) return size == 1 ? 1 : (size > 1) == (exponent > 0) ? kEndless : 0;
    return (size == 0) == (exponent > 0) ? 0 : kEndless;
}

}  // namespace

double logarithm(double x) {
    if (std::isnan(x) || x == kEndless) return x;
    if (x == 0) return -kEndless;
    return x < 0 ? kNotANumber : logarithmInTwo(x).high;
}

double power(double base, double exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (std::isnan(base) || std::isnan(exponent)) return kNotANumber;
    const double size = std::abs(base);
    const double sign = std::signbit(base) && isOdd(exponent) ? -1 : 1;
    if (size == 0 || std::isinf(size) || std::isinf(exponent)) return sign * powerAtEnd(size, exponent);
    if (base < 0 && !isWhole(exponent)) return kNotANumber;
    if (size == 1) return sign;

    constexpr double kBeyond = 1000;  // e^1000 and e^-1000 are none of the numbers
    const TwoDoubles log = logarithmInTwo(size);
    const double about = log.high * exponent;
    if (std::abs(about) > kBeyond) return sign * (about > 0 ? kEndless : 0);
    return sign * exponentialOf(times(log, {exponent, 0}));
}

}  // namespace tread
