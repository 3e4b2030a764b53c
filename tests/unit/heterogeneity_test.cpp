// Heterogeneity between drives, against Cochran's textbook formula and the chi-squared distribution.
#include "inference/heterogeneity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"

namespace tread {
namespace {

using inference::Heterogeneity;
using inference::heterogeneity;
using inference::logBayesFactorOfSpread;

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kEvery = 0;  // share of the information, above which a drive has a say

// Drives that share no nuisance parameter: each has its own estimate and the weight of that, one over its variance.
Heterogeneity independently(const VectorXd& estimates, const VectorXd& weights, double least_share = kEvery) {
    const double mean = weights.dot(estimates) / weights.sum();
    return heterogeneity(weights.asDiagonal(), weights.cwiseProduct(estimates), mean * mean, least_share);
}

TEST(Heterogeneity, OfIndependentDrivesIsCochransSum) {
    const VectorXd estimates{{1.2, 0.7, 1.9, 1.1}}, weights{{20, 5, 8, 60}};
    const double mean = weights.dot(estimates) / weights.sum();
    double q = 0;
    for (Eigen::Index d = 0; d < 4; ++d) q += weights(d) * (estimates(d) - mean) * (estimates(d) - mean);
    const Heterogeneity found = independently(estimates, weights);
    EXPECT_NEAR(found.q, q, 1e-12);
    EXPECT_EQ(found.degrees_of_freedom, 3);
    EXPECT_NEAR(found.spread, std::sqrt(q / 3 / (mean * mean * weights.sum())), 1e-12);
}

// Drives that a nuisance parameter couples: least squares of their estimates about one value, in their covariance.
TEST(Heterogeneity, OfCoupledDrivesIsTheGeneralisedSumOfSquares) {
    const MatrixXd information{{30, -8, -3}, {-8, 12, -2}, {-3, -2, 20}};
    const VectorXd estimates{{0.9, 1.6, 1.3}};
    const auto squares = [&](double value) {
        const VectorXd off = estimates - VectorXd::Constant(3, value);
        return off.dot(information * off);
    };
    double least = squares(0);
    for (double value = 0; value < 3; value += 1e-4) least = std::min(least, squares(value));
    EXPECT_NEAR(heterogeneity(information, information * estimates, 1, kEvery).q, least, 1e-6);
}

TEST(Heterogeneity, DriveThatKnowsLittleHasNoSay) {
    const VectorXd estimates{{1.2, 0.7, 40}}, weights{{20, 5, 0.1}};
    const Heterogeneity all = independently(estimates, weights);
    EXPECT_EQ(all.degrees_of_freedom, 2);
    const Heterogeneity informed = independently(estimates, weights, 0.02);
    EXPECT_EQ(informed.degrees_of_freedom, 1);
    EXPECT_NEAR(informed.q, 4 * 0.25, 1e-12) << "20 x 5 / 25 (1.2 - 0.7)^2";
    EXPECT_EQ(independently(estimates, VectorXd{{20, 0.1, 0.1}}, 0.02).degrees_of_freedom, 0)
        << "nothing to compare with";
    EXPECT_EQ(independently(estimates, VectorXd{{20, 0.1, 0.1}}, 0.02).p, 1);
}

// One true value in all drives: 10^4 draws of their estimates.
TEST(Heterogeneity, UnderOneValueIsChiSquaredWithOneDegreeLessThanThereAreDrives) {
    constexpr int kDraws = 10000;
    const VectorXd weights{{20, 5, 8, 60, 33}};
    const double degrees = 4;
    Random random(11);
    double sum = 0, squares = 0, rejected = 0;
    for (int draw = 0; draw < kDraws; ++draw) {
        VectorXd estimates(5);
        for (Eigen::Index d = 0; d < 5; ++d) estimates(d) = 1.3 + random.normal() / std::sqrt(weights(d));
        const Heterogeneity found = independently(estimates, weights);
        ASSERT_EQ(found.degrees_of_freedom, degrees);
        sum += found.q, squares += found.q * found.q;
        rejected += found.p < 0.05 ? 1 : 0;
    }
    const double mean = sum / kDraws, variance = squares / kDraws - mean * mean;
    // Central moments of chi-squared: variance 2 k, fourth 12 k (k + 4).
    const double fourth = 12 * degrees * (degrees + 4);
    EXPECT_NEAR(mean, degrees, 3 * std::sqrt(2 * degrees / kDraws));
    EXPECT_NEAR(variance, 2 * degrees, 3 * std::sqrt((fourth - 4 * degrees * degrees) / kDraws));
    EXPECT_NEAR(rejected / kDraws, 0.05, 3 * std::sqrt(0.05 * 0.95 / kDraws));
}

// Values that vary by a share v of the true one widen the sum to (1 + v^2 w / m) chi-squared where all drives know the
// value equally well, with the value squared over its variance w of m drives together.
TEST(Heterogeneity, BayesFactorOfSpreadIsTheRatioOfDensitiesOfTheSum) {
    const VectorXd estimates{{1.2, 0.7, 1.9, 1.1}}, weights = VectorXd::Constant(4, 9);
    const Heterogeneity found = independently(estimates, weights);
    const double value = estimates.mean(), w = value * value * weights.sum();
    const auto density = [&](double varies) {  // of q = a chi-squared with 3 degrees
        const double a = 1 + varies * varies * w / 4, x = found.q / a;
        return std::sqrt(x) * std::exp(-x / 2) / (std::sqrt(8.0) * std::tgamma(1.5)) / a;
    };
    EXPECT_NEAR(logBayesFactorOfSpread(found, 0.5, 0.1), std::log(density(0.5) / density(0.1)), 1e-12);
    EXPECT_EQ(logBayesFactorOfSpread(found, 0.3, 0.3), 0);
}

}  // namespace
}  // namespace tread
