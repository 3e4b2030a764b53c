// Linear models with correlated errors: y = r + J x + D d + e, where e is white (all rows already divided by its
// standard deviation), d ~ N(0, diag(s^2)) disturbs, and x ~ N(0, I) is sought. Everything that is asked of such a
// model follows from the scalar products of its columns in the metric (I + D diag(s^2) D')^-1, so the rows are gone
// through once; the metric is never formed (Woodbury).
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tread {

// Scalar products of one drive.
struct DriveGram {
    Eigen::MatrixXd columns;       // W'W
    Eigen::MatrixXd disturbances;  // D'D
    Eigen::MatrixXd mixed;         // D'W
    Eigen::Index rows = 0;
};
DriveGram driveGram(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances);

// The same with further columns behind the present ones.
DriveGram extended(const DriveGram& gram, const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances,
                   const Eigen::MatrixXd& further);

// Scalar products of the columns in the metric of disturbances of these sizes, and what the metric's determinant adds.
struct Gram {
    Eigen::MatrixXd products;
    double log_determinant = 0;  // of I + D diag(s^2) D'
};
Gram whitened(const DriveGram& gram, const Eigen::VectorXd& sizes);

Gram operator+(Gram a, const Gram& b);

// Logarithm of the evidence of the model with the columns `free`, all of prior N(0, 1), for the residual in column
// `residual`; without the constant -rows/2 log(2 pi).
double logEvidence(const Gram& gram, Eigen::Index residual, const std::vector<Eigen::Index>& free);

// The products of the other columns once those in `out` (prior N(0, 1)) are marginalised; rows and columns of `out`
// are left as zeros.
Gram marginalised(const Gram& gram, const std::vector<Eigen::Index>& out);

}  // namespace tread
