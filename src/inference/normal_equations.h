// Linear models with correlated errors:
//
//     y = r + J x + D d + e,    e ~ N(0, I),    d ~ N(0, diag(s^2)),    x ~ N(0, I),
//
// where all rows are divided by the standard deviation of their noise. All results of such a model follow from the
// scalar products of its columns in the metric (I + D diag(s^2) D')^-1, so each drive's rows are read only once. The
// metric itself is never formed (M. A. Woodbury, Inverting modified matrices, 1950).
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "inference/products.h"

namespace tread::inference {

using Index = Eigen::Index;

// Scalar products of the columns W of one drive (J, and usually the residual as the last column) and of its disturbance
// columns D.
struct DriveProducts {
    Eigen::MatrixXd columns;       // W'W
    Eigen::MatrixXd disturbances;  // D'D
    Eigen::MatrixXd mixed;         // D'W
};
DriveProducts productsOf(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances);

// The same with further columns appended.
DriveProducts extended(const DriveProducts& products, const Eigen::MatrixXd& columns,
                       const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& further);

// The same with further columns before the others.
DriveProducts extendedInFront(const Eigen::MatrixXd& further, const DriveProducts& products,
                              const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances);

// The products of the first or last columns alone.
DriveProducts firstColumns(const DriveProducts& products, Index count);
DriveProducts lastColumns(const DriveProducts& products, Index count);

// The products of these columns alone, each multiplied by its factor.
DriveProducts selected(const DriveProducts& products, const std::vector<Index>& columns,
                       const Eigen::VectorXd& factors);
void scaleColumns(DriveProducts& products, const Eigen::VectorXd& factors);

// Products of a further column v with all others, of which W are those before the last.
struct ColumnProducts {
    Eigen::VectorXd with;   // W'v, then that of the last column
    double square = 0;      // v'v
    Eigen::VectorXd mixed;  // D'v
};
ColumnProducts productsOfColumn(const Eigen::VectorXd& column, const Eigen::MatrixXd& columns,
                                const Eigen::VectorXd& last, const Eigen::MatrixXd& disturbances);

// Products after some columns of W have changed. `last`: the last column.
void replaceColumns(DriveProducts& products, const Eigen::MatrixXd& columns, const Eigen::VectorXd& last,
                    const std::vector<Index>& changed, const Eigen::MatrixXd& disturbances);

// Products after the columns before the last one change to W + by step'. The last, the residual, stays.
void updateByRankOne(DriveProducts& products, const ColumnProducts& by, const Eigen::VectorXd& step);
// Products with another last column. `with` ends with its own square.
void replaceLast(DriveProducts& products, const ColumnProducts& last);

// Products of the columns after marginalising the disturbances, and the determinant that this adds to the evidence.
struct NormalEquations {
    Eigen::MatrixXd products;
    double log_determinant = 0;  // of I + D diag(s^2) D', plus those of parameters marginalised later
};

// The metric of disturbances with the standard deviations `sizes`.
struct Metric {
    Eigen::VectorXd sizes;
    Factor factor;  // of I + diag(s) D'D diag(s)
};
Metric metricOf(const Eigen::MatrixXd& disturbances, const Eigen::VectorXd& sizes);

// Marginalises the disturbances (D13).
NormalEquations normalEquations(const DriveProducts& products, const Eigen::VectorXd& sizes);

// Products beside the disturbances, and what the columns leave in these: their posterior means for each column (a unit
// of it as residual) and posterior variances, in units of the prior standard deviation.
struct DisturbedProducts {
    Eigen::MatrixXd products;
    Eigen::MatrixXd estimates;  // disturbances x columns
    Eigen::VectorXd variances;
};

// The same while the columns change and the disturbances keep their sizes.
class MarginalProducts {
public:
    MarginalProducts(const DriveProducts& products, Metric metric);

    const NormalEquations& equations() const { return equations_; }
    const Metric& metric() const { return metric_; }
    DisturbedProducts disturbed() const;

    // As the functions of the same names do with the products, which have changed before.
    void replaceColumns(const DriveProducts& products, const std::vector<Index>& changed);
    void updateByRankOne(const ColumnProducts& by, const Eigen::VectorXd& step);
    void replaceLast(const ColumnProducts& last);
    void scaleColumns(const Eigen::VectorXd& factors);

private:
    Eigen::VectorXd halfOf(const Eigen::VectorXd& mixed) const;

    Metric metric_;
    Eigen::MatrixXd half_;  // L^-1 S D'W with the factor L of the metric: W'W - half'half are the products
    NormalEquations equations_;
};

DisturbedProducts disturbedProducts(const DriveProducts& products, const Eigen::VectorXd& sizes);

// Squared length of a residual in the metric. `mixed`: D' times the residual.
double squaresIn(const Metric& metric, const Eigen::VectorXd& residual, const Eigen::VectorXd& mixed);

// The residual times the metric (I + D diag(s^2) D')^-1 itself.
Eigen::VectorXd inMetric(const Metric& metric, const Eigen::VectorXd& residual, const Eigen::MatrixXd& disturbances);

NormalEquations operator+(NormalEquations a, const NormalEquations& b);
NormalEquations sumOf(const std::vector<NormalEquations>& all);

// Marginalises the parameters `out`, which have the prior N(0, 1); their rows and columns become zero (D24).
NormalEquations marginalised(const NormalEquations& equations, const std::vector<Index>& out);

// The same for the first `count` parameters; their rows and columns are removed.
NormalEquations withoutFirst(const NormalEquations& equations, Index count);

}  // namespace tread::inference
