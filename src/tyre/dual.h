// A number that carries its derivatives with respect to longitudinal and lateral slip, so that the tyre's formulas,
// written once, also give the slopes that the implicit integrator needs.
#pragma once

#include <cmath>

#include "tyre/trigonometry.h"

namespace tread {

struct Dual {
    double value = 0;
    double by_kappa = 0;
    double by_alpha = 0;

    constexpr Dual() = default;
    constexpr Dual(double v) : value(v) {}
    constexpr Dual(double v, double k, double a) : value(v), by_kappa(k), by_alpha(a) {}

    // f(x) with the known slope df/dx: the chain rule.
    constexpr Dual chain(double f, double slope) const { return {f, slope * by_kappa, slope * by_alpha}; }
};

constexpr Dual operator+(const Dual& x, const Dual& y) {
    return {x.value + y.value, x.by_kappa + y.by_kappa, x.by_alpha + y.by_alpha};
}
constexpr Dual operator-(const Dual& x, const Dual& y) {
    return {x.value - y.value, x.by_kappa - y.by_kappa, x.by_alpha - y.by_alpha};
}
constexpr Dual operator*(const Dual& x, const Dual& y) {
    return {x.value * y.value, x.by_kappa * y.value + x.value * y.by_kappa,
            x.by_alpha * y.value + x.value * y.by_alpha};
}
constexpr Dual operator+(const Dual& x, double y) { return {x.value + y, x.by_kappa, x.by_alpha}; }
constexpr Dual operator+(double x, const Dual& y) { return y + x; }
constexpr Dual operator-(const Dual& x, double y) { return {x.value - y, x.by_kappa, x.by_alpha}; }
constexpr Dual operator*(double x, const Dual& y) { return {x * y.value, x * y.by_kappa, x * y.by_alpha}; }
constexpr Dual operator*(const Dual& x, double y) { return y * x; }
constexpr Dual operator/(const Dual& x, const Dual& y) {
    const double inverse = 1 / y.value;
    const double quotient = x.value * inverse;
    return {quotient, (x.by_kappa - quotient * y.by_kappa) * inverse, (x.by_alpha - quotient * y.by_alpha) * inverse};
}

constexpr double valueOf(double x) { return x; }
constexpr double valueOf(const Dual& x) { return x.value; }

inline Dual sine(const Dual& x) {
    const SineCosine both = sineCosine(x.value);
    return x.chain(both.sine, both.cosine);
}
inline Dual cosine(const Dual& x) {
    const SineCosine both = sineCosine(x.value);
    return x.chain(both.cosine, -both.sine);
}
inline Dual arctan(const Dual& x) { return x.chain(arctan(x.value), 1 / (1 + x.value * x.value)); }

// cos(arctan x), exact without trigonometry.
inline double cosArctan(double x) { return 1 / std::sqrt(1 + x * x); }
inline Dual cosArctan(const Dual& x) {
    const double c = cosArctan(x.value);
    return x.chain(c, -x.value * c * c * c);
}

}  // namespace tread
