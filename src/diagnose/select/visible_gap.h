// Whether what a model leaves is larger than chance can make it.
#pragma once

#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

// Probability that noise, disturbances of the usual sizes and errors of the signatures leave a filtered gap as large as
// that of `rows` in a channel or drive, or errors of readings as large as those of `fit` in a kind: that of the least
// probable of them times their number, hence at most the probability that chance does so in any of them. The parameters
// of `fit` explain what they can (D33b, D33f).
double chanceOfGap(const Calibration& car, const Fit& fit, const Rows& rows);

}  // namespace tread::diagnose::select
