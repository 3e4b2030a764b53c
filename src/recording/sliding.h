// Where a drive stops telling anything about the car: once the car slides and its model does not, or the other way
// round, what they do differs by more than any small cause explains; and once an input of the driver is missing.
#pragma once

#include <Eigen/Dense>

#include "recording/recorded_drive.h"

namespace tread::recording {

// When they begin to, s; infinity when they do not. `model` are the rows of a model in the drive. The sideslip angle is
// seen to change from lateral acceleration, yaw rate and speed; nothing can be said without one of these, or with gaps.
// (D6).
double slideApart(const RecordedDrive& drive, const Eigen::VectorXd& model);

}  // namespace tread::recording
