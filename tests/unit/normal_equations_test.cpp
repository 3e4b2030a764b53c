// Scalar products in the metric of noise and disturbances, against dense closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "base/math/random.h"
#include "inference/normal_equations.h"
#include "shared/linear_model.h"

namespace tread::normal_equations_test {
namespace {

using inference::disturbedProducts;
using inference::DisturbedProducts;
using inference::DriveProducts;
using inference::extended;
using inference::marginalised;
using inference::NormalEquations;
using inference::normalEquations;
using inference::productsOf;
using linear_model::logEvidence;

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
    Random random(seed);
    MatrixXd m(rows, columns);
    for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = random.normal();
    return m;
}

struct Dense {                                  // y ~ N(0, I + D S S D' + J J'), formed in full
    MatrixXd columns = randomMatrix(40, 4, 1);  // the last is the residual
    MatrixXd disturbances = randomMatrix(40, 6, 2);
    VectorXd sizes = randomMatrix(6, 1, 3).cwiseAbs();

    NormalEquations equations() const { return normalEquations(productsOf(columns, disturbances), sizes); }
    MatrixXd metric() const {
        const MatrixXd scaled = disturbances * sizes.asDiagonal();
        return MatrixXd::Identity(40, 40) + scaled * scaled.transpose();
    }
};

double logDeterminant(const MatrixXd& m) {
    return std::log(m.determinant());
}

TEST(NormalEquations, ProductsAreThoseInTheDenseMetric) {
    const Dense dense;
    const NormalEquations equations = dense.equations();
    const MatrixXd expected = dense.columns.transpose() * dense.metric().inverse() * dense.columns;
    EXPECT_LT((equations.products - expected).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_NEAR(equations.log_determinant, logDeterminant(dense.metric()), 1e-10);
}

// The posterior of impulses a ~ N(0, 1), of which each makes `sizes` times its column.
TEST(NormalEquations, ImpulsesAreEstimatedAsInTheDensePosterior) {
    const Dense dense;
    const DisturbedProducts found = disturbedProducts(productsOf(dense.columns, dense.disturbances), dense.sizes);
    const MatrixXd scaled = dense.disturbances * dense.sizes.asDiagonal();
    const MatrixXd posterior = (MatrixXd::Identity(6, 6) + scaled.transpose() * scaled).inverse();
    EXPECT_LT((found.products - dense.equations().products).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((found.estimates - posterior * scaled.transpose() * dense.columns).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((found.variances - posterior.diagonal()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(NormalEquations, EvidenceIsThatOfTheDenseCovariance) {
    const Dense dense;
    const NormalEquations equations = dense.equations();
    const MatrixXd jacobian = dense.columns.leftCols(3);
    const VectorXd residual = dense.columns.col(3);
    const MatrixXd covariance = dense.metric() + jacobian * jacobian.transpose();
    const double expected = -0.5 * residual.dot(covariance.inverse() * residual) - 0.5 * logDeterminant(covariance);
    EXPECT_NEAR(logEvidence(equations, 3, {0, 1, 2}), expected, 1e-9);
}

TEST(NormalEquations, MarginalisingInTwoStepsIsMarginalisingAtOnce) {
    const Dense dense;
    const NormalEquations equations = dense.equations();
    const NormalEquations at_once = marginalised(equations, {0, 2});
    const NormalEquations in_steps = marginalised(marginalised(equations, {2}), {0});
    EXPECT_LT((at_once.products - in_steps.products).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_NEAR(at_once.log_determinant, in_steps.log_determinant, 1e-10);
}

TEST(NormalEquations, FurtherColumnsAreAsIfTheyHadBeenThereFromTheStart) {
    const Dense dense;
    const DriveProducts whole = productsOf(dense.columns, dense.disturbances);
    const MatrixXd first = dense.columns.leftCols(2);
    const DriveProducts grown =
        extended(productsOf(first, dense.disturbances), first, dense.disturbances, dense.columns.rightCols(2));
    EXPECT_LT((grown.columns - whole.columns).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((grown.mixed - whole.mixed).cwiseAbs().maxCoeff(), 1e-12);
    const MatrixXd last = dense.columns.rightCols(2);
    const DriveProducts in_front =
        inference::extendedInFront(first, inference::lastColumns(whole, 2), last, dense.disturbances);
    EXPECT_LT((in_front.columns - whole.columns).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((in_front.mixed - whole.mixed).cwiseAbs().maxCoeff(), 1e-12);
}

// Products that are kept up to date while the columns change are those of the changed columns.
TEST(NormalEquations, ProductsFollowTheirColumns) {
    const Dense dense;
    MatrixXd columns = dense.columns.leftCols(3);
    VectorXd residual = dense.columns.col(3);
    DriveProducts products = productsOf(dense.columns, dense.disturbances);
    inference::MarginalProducts marginal(products, inference::metricOf(products.disturbances, dense.sizes));
    const auto expectThoseOf = [&] {
        MatrixXd all(columns.rows(), 4);
        all << columns, residual;
        const DriveProducts anew = productsOf(all, dense.disturbances);
        EXPECT_LT((products.columns - anew.columns).cwiseAbs().maxCoeff(), 1e-10);
        EXPECT_LT((products.mixed - anew.mixed).cwiseAbs().maxCoeff(), 1e-10);
        const MatrixXd expected = all.transpose() * dense.metric().inverse() * all;
        EXPECT_LT((marginal.equations().products - expected).cwiseAbs().maxCoeff(), 1e-10);
    };

    const VectorXd by = randomMatrix(40, 1, 4), step = randomMatrix(3, 1, 5);
    const auto of_step = inference::productsOfColumn(by, columns, residual, dense.disturbances);
    inference::updateByRankOne(products, of_step, step);
    marginal.updateByRankOne(of_step, step);
    columns += by * step.transpose();
    expectThoseOf();

    residual = randomMatrix(40, 1, 6);
    const auto of_residual = inference::productsOfColumn(residual, columns, residual, dense.disturbances);
    inference::replaceLast(products, of_residual);
    marginal.replaceLast(of_residual);
    expectThoseOf();

    const std::vector<Eigen::Index> changed{2, 0};
    columns(Eigen::all, changed) = randomMatrix(40, 2, 7);
    inference::replaceColumns(products, columns, residual, changed, dense.disturbances);
    marginal.replaceColumns(products, changed);
    expectThoseOf();

    const Eigen::Vector4d factors(2, 1, 0.5, 1);
    inference::scaleColumns(products, factors);
    marginal.scaleColumns(factors);
    columns = (columns * factors.head(3).asDiagonal()).eval();
    expectThoseOf();
}

TEST(NormalEquations, SelectedProductsAreThoseOfTheSelectedColumns) {
    const Dense dense;
    const DriveProducts whole = productsOf(dense.columns, dense.disturbances);
    const Eigen::Vector2d factors(3, 0.5);
    MatrixXd columns(40, 2);
    columns << 3 * dense.columns.col(2), 0.5 * dense.columns.col(0);
    const DriveProducts found = inference::selected(whole, {2, 0}, factors);
    const DriveProducts expected = productsOf(columns, dense.disturbances);
    EXPECT_LT((found.columns - expected.columns).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((found.mixed - expected.mixed).cwiseAbs().maxCoeff(), 1e-12);
    const DriveProducts first = inference::firstColumns(whole, 2);
    EXPECT_EQ(first.columns, whole.columns.topLeftCorner(2, 2));
    EXPECT_EQ(first.mixed, whole.mixed.leftCols(2));
}

}  // namespace
}  // namespace tread::normal_equations_test
