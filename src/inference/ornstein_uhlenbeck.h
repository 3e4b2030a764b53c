// Ornstein-Uhlenbeck process: Gaussian noise with exponential correlation (G. E. Uhlenbeck, L. S. Ornstein, 1930).
#pragma once

#include <Eigen/Dense>

namespace tread::inference {

// Cholesky factor of the correlation of `count` values of such a process, `spacing` apart: the factor times independent
// impulses of unit variance gives values of unit variance. `correlation_time` is in the unit of `spacing` (D11).
Eigen::MatrixXd correlationFactor(Eigen::Index count, double spacing, double correlation_time);

}  // namespace tread::inference
