// The end of the usable part of a drive. Once the car slides and its model does not, or the other way round, their
// difference is larger than any small cause explains.
#pragma once

#include <Eigen/Dense>

#include "recording/recorded_drive.h"

namespace tread::recording {

// rad, by which the sideslip angles of car and model part within the window: about the sideslip angle of a car that
// still grips. Raising it compares more of a slide.
inline constexpr double kSlideAngle = 0.08;
inline constexpr double kSlideWindow = 1.5;  // s

// Time, s, at which car and model start to slide apart; infinity if they do not. `model`: rows of a model in the drive.
// The change of the sideslip angle follows from lateral velocity and speed, or else from lateral acceleration, yaw rate
// and speed; infinity when one of them is missing or has gaps (D6).
double slideApart(const RecordedDrive& drive, const Eigen::VectorXd& model);

}  // namespace tread::recording
