// Where a drive stops telling anything about the car: once it spins, chance decides what it does.
#pragma once

#include "diagnose/drive.h"

namespace tread {

// When a spin begins, s; infinity when there is none. `rows` are what was measured in the drive, or what a model shows
// in it. The sideslip angle is seen to change from lateral acceleration, yaw rate and speed; a drive without one of
// these, or with gaps in them, has no spin.
double spinBegins(const RecordedDrive& drive, const Eigen::VectorXd& rows);

}  // namespace tread
