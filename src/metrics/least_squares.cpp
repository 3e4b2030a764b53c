#include "metrics/least_squares.h"

#include <Eigen/QR>

namespace tread {

Eigen::VectorXd leastSquares(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target) {
    return terms.colPivHouseholderQr().solve(target);
}

}  // namespace tread
