// A number that carries its derivatives with respect to longitudinal and lateral slip, so that the tyre's formulas,
// written once, also give the slopes that the implicit integrator needs. T is double or Lanes.
#pragma once

#include "base/math/elementary.h"

namespace tread {
inline namespace TREAD_ISA {

template <class T>
struct Dual {
    T value = 0;
    T by_kappa = 0;
    T by_alpha = 0;

    Dual() = default;
    Dual(const T& v) : value(v) {}
    Dual(const T& v, const T& k, const T& a) : value(v), by_kappa(k), by_alpha(a) {}

    // f(x) with the known slope df/dx: the chain rule.
    Dual chain(const T& f, const T& slope) const { return {f, slope * by_kappa, slope * by_alpha}; }

    friend Dual operator+(const Dual& x, const Dual& y) {
        return {x.value + y.value, x.by_kappa + y.by_kappa, x.by_alpha + y.by_alpha};
    }
    friend Dual operator-(const Dual& x, const Dual& y) {
        return {x.value - y.value, x.by_kappa - y.by_kappa, x.by_alpha - y.by_alpha};
    }
    friend Dual operator*(const Dual& x, const Dual& y) {
        return {x.value * y.value, x.by_kappa * y.value + x.value * y.by_kappa,
                x.by_alpha * y.value + x.value * y.by_alpha};
    }
    friend Dual operator+(const Dual& x, const T& y) { return {x.value + y, x.by_kappa, x.by_alpha}; }
    friend Dual operator-(const Dual& x, const T& y) { return {x.value - y, x.by_kappa, x.by_alpha}; }
    friend Dual operator*(const T& x, const Dual& y) { return {x * y.value, x * y.by_kappa, x * y.by_alpha}; }
    friend Dual operator/(const Dual& x, const Dual& y) {
        const T inverse = 1.0 / y.value;
        const T quotient = x.value * inverse;
        return {quotient, (x.by_kappa - quotient * y.by_kappa) * inverse,
                (x.by_alpha - quotient * y.by_alpha) * inverse};
    }
};

template <class T>
const T& valueOf(const T& x) {
    return x;
}
template <class T>
const T& valueOf(const Dual<T>& x) {
    return x.value;
}

template <class T>
Dual<T> sine(const Dual<T>& x) {
    const SineCosine<T> both = sineCosine(x.value);
    return x.chain(both.sine, both.cosine);
}
template <class T>
Dual<T> cosine(const Dual<T>& x) {
    const SineCosine<T> both = sineCosine(x.value);
    return x.chain(both.cosine, -both.sine);
}
template <class T>
Dual<T> arctan(const Dual<T>& x) {
    return x.chain(arctan(x.value), 1.0 / (1.0 + x.value * x.value));
}
template <class T>
Dual<T> cosArctan(const Dual<T>& x) {
    const T c = cosArctan(x.value);
    return x.chain(c, -x.value * c * c * c);
}

}  // namespace TREAD_ISA
}  // namespace tread
