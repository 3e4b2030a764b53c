// Laws that a force of unknown cause may follow. A force that no effect of the catalogue explains may depend on the
// motion of the car. Such a law does not name the cause, but it separates an unknown cause from the most similar
// effect, and shows where to look.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

// The law that gains most beside a model. Its forces are combined from the columns of the disturbances, so nothing is
// simulated (D35).
answer::ForceLaw forceLaw(const Calibration& car, const Fit& fit);

}  // namespace tread::diagnose::select
