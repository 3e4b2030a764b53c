// Vectors and attitudes across the border with Bullet, in either precision.
#pragma once

#include <LinearMath/btMatrix3x3.h>
#include <LinearMath/btQuaternion.h>
#include <LinearMath/btVector3.h>

#include "tread/bullet_precision.h"
#include "tread/vector.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

inline Vector3 fromBullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
inline Eigen::Matrix3d fromBullet(const btMatrix3x3& m) {
    Eigen::Matrix3d axes;
    for (int row = 0; row < 3; ++row) axes.row(row) = fromBullet(m[row]);
    return axes;
}
inline Quaternion fromBullet(const btQuaternion& q) {
    return {q.w(), q.x(), q.y(), q.z()};
}

inline btVector3 toBullet(const Vector3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
inline btQuaternion toBullet(const Quaternion& q) {
    return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
            static_cast<btScalar>(q.w())};
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
