// Response of a car to short pushes at every instant of a drive. A push is a triangular hat function of time; any
// slowly varying push is a sum of hats, so the response to it is the same sum of their responses.
#pragma once

#include <Eigen/Dense>
#include <cstddef>

#include "run/push.h"

namespace tread::blind::detectability {

inline constexpr double kHatSpacing = 0.1;      // s, from one peak to the next, and half the width of a hat
inline constexpr double kUnitPush = 100;        // N or N m, height of a hat
inline constexpr std::size_t kHatForces = 4;    // longitudinal, lateral (N), roll, yaw (N m)
inline constexpr std::size_t kHatsPerRun = 20;  // one run has a hat every 2 s: by then only its loss of speed remains

// Every kHatsPerRun-th hat from the `first` on, on generalised force `kind` (0 to kHatForces - 1).
Pushing hats(std::size_t kind, std::size_t first);

// Separates the change of the rows by hats(kind, first) into the response to each hat, a column of `by_hat`: the change
// until the next hat begins, and from there on that of a car whose lower speed the hat has caused. `by_start_speed`:
// change of the rows per m/s of the speed at the start.
void separateHats(Eigen::VectorXd change, std::size_t first, const Eigen::VectorXd& by_start_speed,
                  Eigen::MatrixXd& by_hat);

}  // namespace tread::blind::detectability
