// Linear least squares for all manoeuvres. Eigen's decomposition is slow to compile, so that only one file contains it.
#pragma once

#include <Eigen/Core>

namespace tread {

// The x for which |terms x - target| is least; where several are, one of them.
Eigen::VectorXd leastSquares(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target);

}  // namespace tread
