// Maximum of a quadratic model with bounds on its parameters.
#pragma once

#include "inference/laplace.h"

namespace tread::inference {

struct Bounds {
    Eigen::VectorXd lowest, highest;
};

// Step that maximises the log posterior of the model within lowest <= at + step <= highest, by an active-set method.
// `damping` (K. Levenberg, 1944; D. W. Marquardt, 1963) is added to the information, in units of the prior's (D21).
Eigen::VectorXd boundedStep(const QuadraticModel& model, double damping, const Bounds& bounds);

}  // namespace tread::inference
