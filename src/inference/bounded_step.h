// The best step of a quadratic model whose parameters have limits.
#pragma once

#include "inference/laplace.h"

namespace tread::inference {

// The step that maximises the log posterior of the model within lowest <= at + step <= highest, by an active set: from
// bound to bound uphill, and off a bound again where that helps. `damping` (K. Levenberg, 1944; D. W. Marquardt, 1963)
// is added to the prior's information, so many times it (D21).
Eigen::VectorXd boundedStep(const QuadraticModel& model, double damping, const Eigen::VectorXd& lowest,
                            const Eigen::VectorXd& highest);

}  // namespace tread::inference
