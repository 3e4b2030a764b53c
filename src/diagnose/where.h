// Where model and car differ: by channel, recording, phase of the manoeuvre, frequency band and operating regime.
#pragma once

#include "diagnose/missing_force.h"

namespace tread {

// What each row of a drive may be off by when the model is right: noise and disturbances.
Eigen::VectorXd floorOf(const Uncertainty& uncertainty, std::size_t drive);

WhereItLies whereItLies(const Study& study, const MissingForce& missing);

}  // namespace tread
