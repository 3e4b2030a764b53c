// Several doubles that are computed with as one: formulas, written once over a number type, run on the four wheels of a
// car together, or on several cars. Each lane gets exactly what the same operations give for a double.
//
// What is computed with lanes is compiled once for each set of instructions (TREAD_ISA names which), and chosen at run
// time. Operators are always inlined and functions live in a namespace of their own per
// instruction set, so that the linker never takes one for the other.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "tread/wheels.h"

#ifndef TREAD_ISA
#define TREAD_ISA portable
#endif
#define TREAD_INLINE [[gnu::always_inline]]

namespace tread {

// The compiler's vectors of N numbers.
template <int N>
struct PackOf;
template <>
struct PackOf<4> {
    typedef double Numbers __attribute__((vector_size(32)));
    typedef std::int64_t Integers __attribute__((vector_size(32)));
};
template <>
struct PackOf<8> {
    typedef double Numbers __attribute__((vector_size(64)));
    typedef std::int64_t Integers __attribute__((vector_size(64)));
};
// Answer of a comparison, per lane: all bits set where it holds.
template <int N>
struct alignas(8 * N) LaneMaskOf {
    using Vector = typename PackOf<N>::Integers;
    Vector bits;

    TREAD_INLINE friend LaneMaskOf operator&(const LaneMaskOf& a, const LaneMaskOf& b) { return {a.bits & b.bits}; }
    TREAD_INLINE friend LaneMaskOf operator|(const LaneMaskOf& a, const LaneMaskOf& b) { return {a.bits | b.bits}; }
    TREAD_INLINE friend LaneMaskOf operator!(const LaneMaskOf& a) { return {~a.bits}; }
};

template <int N>
struct alignas(8 * N) LanesOf {
    using Vector = typename PackOf<N>::Numbers;
    using Mask = LaneMaskOf<N>;
    Vector lane;

    LanesOf() = default;
    TREAD_INLINE LanesOf(double all) : lane(all - Vector{}) {}  // x - 0 is x for every x
    TREAD_INLINE explicit LanesOf(const Vector& v) : lane(v) {}

    TREAD_INLINE double operator[](std::size_t i) const { return lane[i]; }
    TREAD_INLINE void set(std::size_t i, double x) { lane[i] = x; }

    TREAD_INLINE LanesOf operator-() const { return LanesOf(-lane); }
    TREAD_INLINE LanesOf& operator+=(const LanesOf& x) { return *this = *this + x; }
    TREAD_INLINE LanesOf& operator-=(const LanesOf& x) { return *this = *this - x; }
    TREAD_INLINE LanesOf& operator*=(const LanesOf& x) { return *this = *this * x; }

    TREAD_INLINE friend LanesOf operator+(const LanesOf& a, const LanesOf& b) { return LanesOf(a.lane + b.lane); }
    TREAD_INLINE friend LanesOf operator-(const LanesOf& a, const LanesOf& b) { return LanesOf(a.lane - b.lane); }
    TREAD_INLINE friend LanesOf operator*(const LanesOf& a, const LanesOf& b) { return LanesOf(a.lane * b.lane); }
    TREAD_INLINE friend LanesOf operator/(const LanesOf& a, const LanesOf& b) { return LanesOf(a.lane / b.lane); }
    TREAD_INLINE friend Mask operator<(const LanesOf& a, const LanesOf& b) { return {a.lane < b.lane}; }
    TREAD_INLINE friend Mask operator>(const LanesOf& a, const LanesOf& b) { return {a.lane > b.lane}; }
    TREAD_INLINE friend Mask operator<=(const LanesOf& a, const LanesOf& b) { return {a.lane <= b.lane}; }
    TREAD_INLINE friend Mask operator>=(const LanesOf& a, const LanesOf& b) { return {a.lane >= b.lane}; }
    TREAD_INLINE friend Mask operator==(const LanesOf& a, const LanesOf& b) { return {a.lane == b.lane}; }
    TREAD_INLINE friend Mask operator!=(const LanesOf& a, const LanesOf& b) { return {a.lane != b.lane}; }
};
using Lanes = LanesOf<4>;  // the wheels of a car
// A vector's own alignment differs between instruction sets; files compiled for different ones share these structs.
static_assert(alignof(Lanes) == 32 && alignof(LaneMaskOf<4>) == 32);

inline namespace TREAD_ISA {

// ---- Choosing and asking, for lanes and for plain numbers ----

template <int N>
LanesOf<N> select(const LaneMaskOf<N>& where, const LanesOf<N>& a, const LanesOf<N>& b) {
    return LanesOf<N>(where.bits ? a.lane : b.lane);
}
constexpr double select(bool where, double a, double b) {
    return where ? a : b;
}

template <int N>
bool any(const LaneMaskOf<N>& m) {
    std::int64_t bits = m.bits[0];
    for (int i = 1; i < N; ++i) bits |= m.bits[i];
    return bits != 0;
}
constexpr bool any(bool m) {
    return m;
}
template <int N>
bool all(const LaneMaskOf<N>& m) {
    std::int64_t bits = m.bits[0];
    for (int i = 1; i < N; ++i) bits &= m.bits[i];
    return bits != 0;
}
constexpr bool all(bool m) {
    return m;
}

template <class T>
struct NumberTraits;
template <>
struct NumberTraits<double> {
    using Mask = bool;
    using Bits = std::int64_t;
};
template <int N>
struct NumberTraits<LanesOf<N>> {
    using Mask = LaneMaskOf<N>;
    using Bits = typename LaneMaskOf<N>::Vector;
};
template <class T>
using MaskOf = typename NumberTraits<T>::Mask;
template <class T>
using BitsOf = typename NumberTraits<T>::Bits;

// ---- The number of one lane; a double is a single lane ----

template <class T>
inline constexpr std::size_t kLanesOf = 1;
template <int N>
inline constexpr std::size_t kLanesOf<LanesOf<N>> = N;

TREAD_INLINE inline double lane(double x, std::size_t) {
    return x;
}
TREAD_INLINE inline bool lane(bool x, std::size_t) {
    return x;
}
template <int N>
TREAD_INLINE inline double lane(const LanesOf<N>& x, std::size_t i) {
    return x[i];
}
template <int N>
TREAD_INLINE inline bool lane(const LaneMaskOf<N>& x, std::size_t i) {
    return x.bits[i] != 0;
}
TREAD_INLINE inline void setLane(double& x, std::size_t, double value) {
    x = value;
}
template <int N>
TREAD_INLINE inline void setLane(LanesOf<N>& x, std::size_t i, double value) {
    x.set(i, value);
}

// A struct of nothing but numbers, chosen member by member.
template <template <class> class Struct, class T>
Struct<T> select(const MaskOf<T>& where, const Struct<T>& a, const Struct<T>& b) {
    constexpr std::size_t kMembers = sizeof(Struct<T>) / sizeof(T);
    const auto x = std::bit_cast<std::array<T, kMembers>>(a);
    const auto y = std::bit_cast<std::array<T, kMembers>>(b);
    std::array<T, kMembers> chosen;
    for (std::size_t i = 0; i < kMembers; ++i) chosen[i] = select(where, x[i], y[i]);
    return std::bit_cast<Struct<T>>(chosen);
}

// ---- Functions with the same bits for lanes and for plain numbers ----

template <class T>
T magnitude(const T& x) {
    return std::bit_cast<T>(std::bit_cast<BitsOf<T>>(x) & INT64_MAX);
}
// The magnitude of one number with the sign of another.
template <class T>
T withSign(const T& size, const T& sign) {
    const auto bits = (std::bit_cast<BitsOf<T>>(size) & INT64_MAX) | (std::bit_cast<BitsOf<T>>(sign) & INT64_MIN);
    return std::bit_cast<T>(bits);
}
template <class T>
T larger(const T& a, const T& b) {
    return select(a < b, b, a);
}
template <class T>
T smaller(const T& a, const T& b) {
    return select(b < a, b, a);
}
inline double squareRoot(double x) {
    return std::sqrt(x);
}
template <int N>
LanesOf<N> squareRoot(const LanesOf<N>& x) {
    LanesOf<N> root;
    for (int i = 0; i < N; ++i) root.lane[i] = std::sqrt(x.lane[i]);
    return root;
}

// ---- One struct of lanes from one struct per wheel, and back ----

template <template <class> class Struct>
Struct<Lanes> together(const PerWheel<Struct<double>>& wheels) {
    constexpr std::size_t kMembers = sizeof(Struct<double>) / sizeof(double);
    using Members = std::array<double, kMembers>;
    const auto a = std::bit_cast<Members>(wheels.front_left), b = std::bit_cast<Members>(wheels.front_right),
               c = std::bit_cast<Members>(wheels.rear_left), d = std::bit_cast<Members>(wheels.rear_right);
    std::array<Lanes, kMembers> lanes;
    for (std::size_t i = 0; i < kMembers; ++i) lanes[i] = Lanes(Lanes::Vector{a[i], b[i], c[i], d[i]});
    return std::bit_cast<Struct<Lanes>>(lanes);
}

template <template <class> class Struct>
Struct<double> ofWheel(const Struct<Lanes>& lanes, std::size_t wheel) {
    constexpr std::size_t kMembers = sizeof(Struct<double>) / sizeof(double);
    const auto all = std::bit_cast<std::array<Lanes, kMembers>>(lanes);
    std::array<double, kMembers> members;
    for (std::size_t i = 0; i < kMembers; ++i) members[i] = all[i][wheel];
    return std::bit_cast<Struct<double>>(members);
}

}  // namespace TREAD_ISA
}  // namespace tread
