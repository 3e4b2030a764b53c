// Four doubles that are computed with as one: the tyre's formulas, written once over a number type, run on the four
// wheels of a car together. Each lane gets exactly what the same operations give for a double.
//
// What is computed with lanes is compiled once for every x86-64 processor and once for those with AVX2 (TREAD_ISA names
// which), and chosen at run time. Operators are always inlined and functions live in a namespace of their own per
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

// Answer of a comparison, per lane: all bits set where it holds.
struct alignas(32) LaneMask {
    typedef std::int64_t Vector __attribute__((vector_size(32)));
    Vector bits;

    TREAD_INLINE friend LaneMask operator&(const LaneMask& a, const LaneMask& b) { return {a.bits & b.bits}; }
    TREAD_INLINE friend LaneMask operator|(const LaneMask& a, const LaneMask& b) { return {a.bits | b.bits}; }
    TREAD_INLINE friend LaneMask operator!(const LaneMask& a) { return {~a.bits}; }
};

struct alignas(32) Lanes {
    typedef double Vector __attribute__((vector_size(32)));
    Vector lane;

    Lanes() = default;
    TREAD_INLINE Lanes(double all) : lane{all, all, all, all} {}
    TREAD_INLINE Lanes(double a, double b, double c, double d) : lane{a, b, c, d} {}
    TREAD_INLINE explicit Lanes(const Vector& v) : lane(v) {}

    TREAD_INLINE double operator[](std::size_t i) const { return lane[i]; }

    TREAD_INLINE Lanes operator-() const { return Lanes(-lane); }
    TREAD_INLINE Lanes& operator*=(const Lanes& x) { return *this = *this * x; }

    TREAD_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.lane + b.lane); }
    TREAD_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.lane - b.lane); }
    TREAD_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.lane * b.lane); }
    TREAD_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.lane / b.lane); }
    TREAD_INLINE friend LaneMask operator<(const Lanes& a, const Lanes& b) { return {a.lane < b.lane}; }
    TREAD_INLINE friend LaneMask operator>(const Lanes& a, const Lanes& b) { return {a.lane > b.lane}; }
    TREAD_INLINE friend LaneMask operator<=(const Lanes& a, const Lanes& b) { return {a.lane <= b.lane}; }
    TREAD_INLINE friend LaneMask operator>=(const Lanes& a, const Lanes& b) { return {a.lane >= b.lane}; }
    TREAD_INLINE friend LaneMask operator==(const Lanes& a, const Lanes& b) { return {a.lane == b.lane}; }
    TREAD_INLINE friend LaneMask operator!=(const Lanes& a, const Lanes& b) { return {a.lane != b.lane}; }
};
// A vector's own alignment differs between instruction sets; files compiled for different ones share these structs.
static_assert(alignof(Lanes) == 32 && alignof(LaneMask) == 32);

inline namespace TREAD_ISA {

// ---- Choosing and asking, for lanes and for plain numbers ----

inline Lanes select(const LaneMask& where, const Lanes& a, const Lanes& b) {
    return Lanes(where.bits ? a.lane : b.lane);
}
constexpr double select(bool where, double a, double b) {
    return where ? a : b;
}

inline bool any(const LaneMask& m) {
    return (m.bits[0] | m.bits[1] | m.bits[2] | m.bits[3]) != 0;
}
constexpr bool any(bool m) {
    return m;
}
inline bool all(const LaneMask& m) {
    return (m.bits[0] & m.bits[1] & m.bits[2] & m.bits[3]) != 0;
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
template <>
struct NumberTraits<Lanes> {
    using Mask = LaneMask;
    using Bits = LaneMask::Vector;
};
template <class T>
using MaskOf = typename NumberTraits<T>::Mask;
template <class T>
using BitsOf = typename NumberTraits<T>::Bits;

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
inline Lanes squareRoot(const Lanes& x) {
    return {std::sqrt(x.lane[0]), std::sqrt(x.lane[1]), std::sqrt(x.lane[2]), std::sqrt(x.lane[3])};
}

// ---- One struct of lanes from one struct per wheel, and back ----

template <template <class> class Struct>
Struct<Lanes> together(const PerWheel<Struct<double>>& wheels) {
    constexpr std::size_t kMembers = sizeof(Struct<double>) / sizeof(double);
    using Members = std::array<double, kMembers>;
    const auto a = std::bit_cast<Members>(wheels.front_left), b = std::bit_cast<Members>(wheels.front_right),
               c = std::bit_cast<Members>(wheels.rear_left), d = std::bit_cast<Members>(wheels.rear_right);
    std::array<Lanes, kMembers> lanes;
    for (std::size_t i = 0; i < kMembers; ++i) lanes[i] = Lanes(a[i], b[i], c[i], d[i]);
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
