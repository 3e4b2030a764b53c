// The algebra of a diagnosis against dense closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.h"
#include "base/random.h"
#include "inference/normal_equations.h"

namespace tread {
namespace {

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

    MatrixXd metric() const {
        const MatrixXd scaled = disturbances * sizes.asDiagonal();
        return MatrixXd::Identity(40, 40) + scaled * scaled.transpose();
    }
};

double logDeterminant(const MatrixXd& m) {
    return std::log(m.determinant());
}

TEST(Gram, ProductsAreThoseInTheDenseMetric) {
    const Dense dense;
    const Gram gram = whitened(driveGram(dense.columns, dense.disturbances), dense.sizes);
    const MatrixXd expected = dense.columns.transpose() * dense.metric().inverse() * dense.columns;
    EXPECT_LT((gram.products - expected).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_NEAR(gram.log_determinant, logDeterminant(dense.metric()), 1e-10);
}

TEST(Gram, EvidenceIsThatOfTheDenseCovariance) {
    const Dense dense;
    const Gram gram = whitened(driveGram(dense.columns, dense.disturbances), dense.sizes);
    const MatrixXd jacobian = dense.columns.leftCols(3);
    const VectorXd residual = dense.columns.col(3);
    const MatrixXd covariance = dense.metric() + jacobian * jacobian.transpose();
    const double expected = -0.5 * residual.dot(covariance.inverse() * residual) - 0.5 * logDeterminant(covariance);
    EXPECT_NEAR(logEvidence(gram, 3, {0, 1, 2}), expected, 1e-9);
}

TEST(Gram, MarginalisingInTwoStepsIsMarginalisingAtOnce) {
    const Dense dense;
    const Gram gram = whitened(driveGram(dense.columns, dense.disturbances), dense.sizes);
    const Gram at_once = marginalised(gram, {0, 2}), in_steps = marginalised(marginalised(gram, {2}), {0});
    EXPECT_LT((at_once.products - in_steps.products).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_NEAR(at_once.log_determinant, in_steps.log_determinant, 1e-10);
}

TEST(Gram, FurtherColumnsAreAsIfTheyHadBeenThereFromTheStart) {
    const Dense dense;
    const DriveGram whole = driveGram(dense.columns, dense.disturbances);
    const MatrixXd first = dense.columns.leftCols(2);
    const DriveGram grown =
        extended(driveGram(first, dense.disturbances), first, dense.disturbances, dense.columns.rightCols(2));
    EXPECT_LT((grown.columns - whole.columns).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((grown.mixed - whole.mixed).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(InParallel, EveryPieceIsDoneOnceAndTheFirstFailureIsThrown) {
    std::vector<int> done(100, 0);
    inParallel(done.size(), 3, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(100, 1));
    EXPECT_THROW(inParallel(100, 3,
                            [](std::size_t i) {
                                if (i == 7) throw std::runtime_error("seven");
                            }),
                 std::runtime_error);
}

}  // namespace
}  // namespace tread
