// Linear least squares: one instance of Eigen's decomposition serves all manoeuvres, which builds quicker.
#pragma once

#include <Eigen/Core>

namespace tread {

// The x for which |terms x - target| is least; where several are, one of them.
Eigen::VectorXd leastSquares(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target);

}  // namespace tread
