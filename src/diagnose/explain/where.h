// Where model and car differ: by channel, recording, phase of the manoeuvre, frequency band and operating regime.
#pragma once

#include "diagnose/explain/missing_force.h"

namespace tread::diagnose::explain {

// Standard deviation of each row of a drive when the model is right: noise and disturbances.
Eigen::VectorXd floorOf(const model::Uncertainty& uncertainty, std::size_t drive);

// Shares of the squared gap in excess of noise and disturbances (D46).
answer::WhereItLies whereItLies(const Calibration& car, const MissingForce& missing);

}  // namespace tread::diagnose::explain
