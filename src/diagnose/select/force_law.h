// Laws that a force of unknown cause may follow: what no effect of the catalogue explains, a force that goes with the
// motion of the car may. It has no name, but it tells an unknown cause from the nearest effect that there is, and the
// engineer where to look.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

// The law that gains most beside a model: its forces are those of disturbances, so that nothing is simulated (D35).
answer::ForceLaw forceLaw(const Calibration& car, const Fit& fit);

}  // namespace tread::diagnose::select
