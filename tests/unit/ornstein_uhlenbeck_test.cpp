// Exponentially correlated disturbances, against a Kalman filter (R. E. Kalman, 1960) that meets them sample by sample.
#include "inference/ornstein_uhlenbeck.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/math/random.h"
#include "shared/linear_model.h"

namespace tread::ornstein_uhlenbeck_test {
namespace {

using inference::correlationFactor;
using inference::normalEquations;
using inference::productsOf;
using linear_model::logEvidence;

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr Index kSamples = 50;
constexpr double kSpacing = 0.25, kCorrelationTime = 0.5;  // s
constexpr double kSame = 1e-9;                             // nats

VectorXd someValues() {
    Random random(4);
    VectorXd values(kSamples);
    double wanders = 0;
    for (double& one : values) {
        wanders = 0.6 * wanders + random.normal();
        one = 1.5 * wanders + random.normal();
    }
    return values;
}

// ln p of the values: the process, of standard deviation `size`, seen in white noise of variance 1 beside a constant of
// the variance `constant`.
double kalmanLikelihood(const VectorXd& values, double size, double constant) {
    const double kept = std::exp(-kSpacing / kCorrelationTime);
    Vector2d state(0, 0);  // process, constant
    Matrix2d covariance = Vector2d(size * size, constant).asDiagonal();
    const Vector2d seen(1, 1);
    double sum = 0;
    for (Index k = 0; k < values.size(); ++k) {
        if (k > 0) {
            const Matrix2d transition = Vector2d(kept, 1).asDiagonal();
            state = transition * state;
            covariance = transition * covariance * transition;
            covariance(0, 0) += size * size * (1 - kept * kept);
        }
        const double expected = seen.dot(state), variance = seen.dot(covariance * seen) + 1;
        const double surprise = values(k) - expected;
        sum -= 0.5 * (std::log(2 * std::numbers::pi * variance) + surprise * surprise / variance);
        const Vector2d gain = covariance * seen / variance;
        state += gain * surprise;
        covariance -= gain * seen.transpose() * covariance;
    }
    return sum;
}

constexpr double kConstant = -0.5 * kSamples * 1.8378770664093453;  // of the rows: ln(2 pi)

TEST(OrnsteinUhlenbeck, MarginalisedProcessHasTheLikelihoodOfAKalmanFilter) {
    const VectorXd values = someValues();
    const MatrixXd factor = correlationFactor(kSamples, kSpacing, kCorrelationTime);
    for (const double size : {0.0, 0.3, 1.0, 4.0}) {
        const auto equations = normalEquations(productsOf(values, factor), VectorXd::Constant(kSamples, size));
        EXPECT_NEAR(logEvidence(equations, 0, {}) + kConstant, kalmanLikelihood(values, size, 0), kSame) << size;
    }
}

TEST(OrnsteinUhlenbeck, ParameterBesideTheProcessIsMarginalisedAsAKalmanFilterDoes) {
    MatrixXd columns(kSamples, 2);
    columns << VectorXd::Ones(kSamples), someValues();
    const MatrixXd factor = correlationFactor(kSamples, kSpacing, kCorrelationTime);
    for (const double size : {0.3, 4.0}) {
        const auto equations = normalEquations(productsOf(columns, factor), VectorXd::Constant(kSamples, size));
        EXPECT_NEAR(logEvidence(equations, 1, {0}) + kConstant, kalmanLikelihood(columns.col(1), size, 1), kSame);
    }
}

TEST(OrnsteinUhlenbeck, ValuesAreCorrelatedAsTheProcessIs) {
    const MatrixXd factor = correlationFactor(20, 0.1, 0.3), correlation = factor * factor.transpose();
    for (Index i = 0; i < 20; ++i) {
        for (Index j = 0; j < 20; ++j)
            EXPECT_NEAR(correlation(i, j), std::exp(-0.1 * std::abs(static_cast<double>(i - j)) / 0.3), 1e-12);
    }
}

}  // namespace
}  // namespace tread::ornstein_uhlenbeck_test
