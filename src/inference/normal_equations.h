// Linear models with correlated errors:
//
//     y = r + J x + D d + e,    e ~ N(0, I),    d ~ N(0, diag(s^2)),    x ~ N(0, I),
//
// where all rows are already divided by the standard deviation of their noise. Everything that is asked of such a model
// follows from the scalar products of its columns in the metric (I + D diag(s^2) D')^-1, so the rows are gone through
// once per drive. The metric is never formed (M. A. Woodbury, Inverting modified matrices, 1950).
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

namespace tread::inference {

using Index = Eigen::Index;

// Scalar products of the columns W of one drive (J, and usually the residual as the last column) and of what disturbs
// it, D.
struct DriveProducts {
    Eigen::MatrixXd columns;       // W'W
    Eigen::MatrixXd disturbances;  // D'D
    Eigen::MatrixXd mixed;         // D'W
};
DriveProducts productsOf(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances);

// The same with further columns behind the present ones.
DriveProducts extended(const DriveProducts& products, const Eigen::MatrixXd& columns,
                       const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& further);

// Products of the columns once the disturbances are marginalised, and what that adds to the evidence.
struct NormalEquations {
    Eigen::MatrixXd products;
    double log_determinant = 0;  // of I + D diag(s^2) D', and of all that was marginalised after it
};

// Marginalises disturbances of the standard deviations `sizes` (D13).
NormalEquations normalEquations(const DriveProducts& products, const Eigen::VectorXd& sizes);

NormalEquations operator+(NormalEquations a, const NormalEquations& b);

// The equations once the parameters in `out`, of prior N(0, 1), are marginalised; their rows and columns are left as
// zeros (D24).
NormalEquations marginalised(const NormalEquations& equations, const std::vector<Index>& out);

// The same for the first `count` parameters; only the others are left.
NormalEquations withoutFirst(const NormalEquations& equations, Index count);

}  // namespace tread::inference
