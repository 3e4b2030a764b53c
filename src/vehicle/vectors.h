// Vectors over the numbers with which a car is computed: Eigen's for double, and for lanes, of which each holds another
// car, vectors with the same names and the same order of operations. Eigen's own templates are not instantiated for
// lanes: the linker could take those of one instruction set for another (base/math/lanes.h).
#pragma once

#include "base/math/elementary.h"
#include "tread/vector.h"

namespace tread {
inline namespace TREAD_ISA {

template <class T>
class LaneVector {
public:
    LaneVector() = default;
    TREAD_INLINE LaneVector(const T& x, const T& y, const T& z) : x_(x), y_(y), z_(z) {}
    TREAD_INLINE static LaneVector Zero() { return {0.0, 0.0, 0.0}; }

    TREAD_INLINE T& x() { return x_; }
    TREAD_INLINE T& y() { return y_; }
    TREAD_INLINE T& z() { return z_; }
    TREAD_INLINE const T& x() const { return x_; }
    TREAD_INLINE const T& y() const { return y_; }
    TREAD_INLINE const T& z() const { return z_; }

    TREAD_INLINE LaneVector cross(const LaneVector& b) const {
        return {y_ * b.z_ - z_ * b.y_, z_ * b.x_ - x_ * b.z_, x_ * b.y_ - y_ * b.x_};
    }
    TREAD_INLINE LaneVector operator-() const { return {-x_, -y_, -z_}; }
    TREAD_INLINE LaneVector& operator+=(const LaneVector& b) { return *this = *this + b; }
    TREAD_INLINE LaneVector& operator-=(const LaneVector& b) { return *this = *this - b; }

    TREAD_INLINE friend LaneVector operator+(const LaneVector& a, const LaneVector& b) {
        return {a.x_ + b.x_, a.y_ + b.y_, a.z_ + b.z_};
    }
    TREAD_INLINE friend LaneVector operator-(const LaneVector& a, const LaneVector& b) {
        return {a.x_ - b.x_, a.y_ - b.y_, a.z_ - b.z_};
    }
    TREAD_INLINE friend LaneVector operator*(const T& s, const LaneVector& a) { return {s * a.x_, s * a.y_, s * a.z_}; }
    TREAD_INLINE friend LaneVector operator*(const LaneVector& a, const T& s) { return {a.x_ * s, a.y_ * s, a.z_ * s}; }
    TREAD_INLINE friend LaneVector operator/(const LaneVector& a, const T& s) { return {a.x_ / s, a.y_ / s, a.z_ / s}; }

private:
    T x_, y_, z_;
};

// A matrix that turns vectors: its element in row i and column k.
template <class T>
struct LaneRotation {
    T element[3][3];
    TREAD_INLINE T& operator()(int i, int k) { return element[i][k]; }
    TREAD_INLINE const T& operator()(int i, int k) const { return element[i][k]; }
};

template <class T>
class LaneQuaternion {
public:
    LaneQuaternion() = default;
    TREAD_INLINE LaneQuaternion(const T& w, const T& x, const T& y, const T& z) : w_(w), x_(x), y_(y), z_(z) {}
    TREAD_INLINE const T& w() const { return w_; }
    TREAD_INLINE const T& x() const { return x_; }
    TREAD_INLINE const T& y() const { return y_; }
    TREAD_INLINE const T& z() const { return z_; }

private:
    T w_, x_, y_, z_;
};

template <class T>
struct VectorsOver {
    using Vector = LaneVector<T>;
    using Rotation = LaneRotation<T>;
    using Attitude = LaneQuaternion<T>;
};
template <>
struct VectorsOver<double> {
    using Vector = tread::Vector3;
    using Rotation = Eigen::Matrix3d;
    using Attitude = tread::Quaternion;
};
template <class T>
using VectorOf = typename VectorsOver<T>::Vector;
template <class T>
using RotationOf = typename VectorsOver<T>::Rotation;
template <class T>
using AttitudeOf = typename VectorsOver<T>::Attitude;

// ---- What sums: in one order for both ----

TREAD_INLINE inline double dot(const Vector3& a, const Vector3& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
template <class T>
TREAD_INLINE inline T dot(const LaneVector<T>& a, const LaneVector<T>& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
TREAD_INLINE inline double norm(const Vector3& a) {
    return squareRoot(dot(a, a));
}
template <class T>
TREAD_INLINE inline T norm(const LaneVector<T>& a) {
    return squareRoot(dot(a, a));
}

// M a, and the transposed M times a.
template <class Vector, class Rotation>
TREAD_INLINE inline Vector times(const Rotation& m, const Vector& a) {
    return {m(0, 0) * a.x() + m(0, 1) * a.y() + m(0, 2) * a.z(), m(1, 0) * a.x() + m(1, 1) * a.y() + m(1, 2) * a.z(),
            m(2, 0) * a.x() + m(2, 1) * a.y() + m(2, 2) * a.z()};
}
template <class Vector, class Rotation>
TREAD_INLINE inline Vector transposedTimes(const Rotation& m, const Vector& a) {
    return {m(0, 0) * a.x() + m(1, 0) * a.y() + m(2, 0) * a.z(), m(0, 1) * a.x() + m(1, 1) * a.y() + m(2, 1) * a.z(),
            m(0, 2) * a.x() + m(1, 2) * a.y() + m(2, 2) * a.z()};
}

// ---- Attitudes ----

template <class T>
RotationOf<T> rotationOf(const AttitudeOf<T>& q) {
    const T xx = 2.0 * q.x() * q.x(), yy = 2.0 * q.y() * q.y(), zz = 2.0 * q.z() * q.z();
    const T xy = 2.0 * q.x() * q.y(), xz = 2.0 * q.x() * q.z(), yz = 2.0 * q.y() * q.z();
    const T wx = 2.0 * q.w() * q.x(), wy = 2.0 * q.w() * q.y(), wz = 2.0 * q.w() * q.z();
    RotationOf<T> m;
    m(0, 0) = 1.0 - (yy + zz), m(0, 1) = xy - wz, m(0, 2) = xz + wy;
    m(1, 0) = xy + wz, m(1, 1) = 1.0 - (xx + zz), m(1, 2) = yz - wx;
    m(2, 0) = xz - wy, m(2, 1) = yz + wx, m(2, 2) = 1.0 - (xx + yy);
    return m;
}

// The attitude turned by a rotation vector in the world, rad.
template <class T>
AttitudeOf<T> turned(const AttitudeOf<T>& q, const VectorOf<T>& turn) {
    const T angle = norm(turn);
    const SineCosine<T> half = sineCosine(T(0.5 * angle));
    const VectorOf<T> axis = turn * select(angle > T(0), T(half.sine / angle), T(0.5));
    const T w = half.cosine * q.w() - axis.x() * q.x() - axis.y() * q.y() - axis.z() * q.z();
    const T x = half.cosine * q.x() + axis.x() * q.w() + axis.y() * q.z() - axis.z() * q.y();
    const T y = half.cosine * q.y() + axis.y() * q.w() + axis.z() * q.x() - axis.x() * q.z();
    const T z = half.cosine * q.z() + axis.z() * q.w() + axis.x() * q.y() - axis.y() * q.x();
    const T size = squareRoot(T(w * w + x * x + y * y + z * z));
    const auto turns = angle > T(0);  // at rest nothing drifts by rounding
    return {select(turns, T(w / size), T(q.w())), select(turns, T(x / size), T(q.x())),
            select(turns, T(y / size), T(q.y())), select(turns, T(z / size), T(q.z()))};
}

}  // namespace TREAD_ISA
}  // namespace tread
