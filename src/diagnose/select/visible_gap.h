// Whether the gap that a model leaves is larger than chance can make it.
#pragma once

#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

// Probability that noise and disturbances of the usual sizes leave a filtered gap as large as that of `rows` in the
// channel or drive where it is least probable, times the number of channels and drives: at most the probability that
// chance does so in any of them. The parameters of `fit` explain what they can (D33b).
double chanceOfGap(const Calibration& car, const Fit& fit, const Rows& rows);

}  // namespace tread::diagnose::select
