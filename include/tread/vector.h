// Vectors of the public interface. A suffix names the frame where two are in scope: _W world, _B body (ISO 8855: x
// forward, y left, z up, origin at the centre of gravity).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tread {

using Vector3 = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

}  // namespace tread
