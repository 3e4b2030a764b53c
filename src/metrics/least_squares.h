// Linear least squares: one instance of Eigen's decomposition serves all manoeuvres, which builds quicker.
#pragma once

#include <Eigen/Core>

namespace tread {

// The x of least |terms x - target|; of several, the shortest.
Eigen::VectorXd leastSquares(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target);

}  // namespace tread
