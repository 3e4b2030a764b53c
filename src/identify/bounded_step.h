// The best step of a linear model whose parameters have limits.
#pragma once

#include <Eigen/Dense>

namespace tread {

// Step from x, of prior N(0, I), that minimises the quadratic model with this information (J'J) and gradient (J'r);
// prior, damping (times the prior's information) and bounds included: from bound to bound downhill, and off a bound
// again where that helps (active set).
Eigen::VectorXd boundedStep(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient,
                            const Eigen::VectorXd& x, double damping, const Eigen::VectorXd& lowest,
                            const Eigen::VectorXd& highest);

}  // namespace tread
