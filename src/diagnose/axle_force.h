// The side force that the model lacks, at its axles: which end of the car is it?
#pragma once

#include "diagnose/study.h"

namespace tread {

// Sizes of disturbances, large enough that a missing force can be read off. Steering is no force: what it would explain
// shows as lateral force and yaw moment of the front axle.
std::array<double, kDisturbances> readingSizes(const Study& study);

// Heights of the hats of every kind of force that, by the posterior of disturbances of those sizes, the model of a fit
// lacks in a drive; in those sizes.
Eigen::VectorXd missingHats(const Study& study, const Fit& fit, std::size_t drive);

// Shares of the squared side force at `front` and `rear` that would do what the missing lateral force and yaw moment
// do.
Shares axleForce(const Study& study, const Fit& fit);

}  // namespace tread
