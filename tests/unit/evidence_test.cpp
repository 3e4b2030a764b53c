// Evidence, against the integral of prior times likelihood over a fine grid of the parameters.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "inference/bounded_step.h"
#include "inference/laplace.h"
#include "inference/normal_equations.h"

namespace tread::evidence_test {
namespace {

using inference::boundedStep;
using inference::gainOf;
using inference::logEvidence;
using inference::QuadraticModel;

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kSameIntegral = 1e-6;  // nats

// Logarithm of the integral of exp(f) over a rectangle, by the trapezoidal rule: of a function that has died away at
// the edges the rule is right to all digits, of one that is cut off there to the square of the step.
double logIntegral(const std::function<double(const Vector2d&)>& f, const Vector2d& from, const Vector2d& to) {
    constexpr int kSteps = 2000;
    const Vector2d step = (to - from) / kSteps;
    const double most = f(0.5 * (from + to));
    double sum = 0;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            const double weight = (i % kSteps == 0 ? 0.5 : 1) * (j % kSteps == 0 ? 0.5 : 1);
            sum += weight * std::exp(f(from + Vector2d(i, j).cwiseProduct(step)) - most);
        }
    }
    return std::log(sum * step.prod()) + most;
}

// Six rows that two parameters move, in units of their noise.
struct Rows {
    MatrixXd columns{{0.5, 0.2}, {-0.3, 0.8}, {1.1, 0.4}, {0.2, -0.9}, {0.7, 0.6}, {-0.4, 0.1}};
    VectorXd measured{{1.4, 0.3, 2.2, -1.1, 1.9, -0.5}};

    // Logarithm of prior times likelihood, but for the rows' constant.
    double logPosterior(const Vector2d& x) const {
        return -0.5 * (measured - columns * x).squaredNorm() - 0.5 * x.squaredNorm() - std::log(2 * std::numbers::pi);
    }
    QuadraticModel about(const Vector2d& at) const {
        const VectorXd left = measured - columns * at;
        return {.information = columns.transpose() * columns,
                .gradient = columns.transpose() * left,
                .at = at,
                .squared_residual = left.squaredNorm()};
    }
};

TEST(Evidence, IsTheIntegralOfPriorTimesLikelihoodWhereverTheModelIsLinearised) {
    const Rows rows;
    const double integral = logIntegral([&](const Vector2d& x) { return rows.logPosterior(x); }, {-9, -9}, {9, 9});
    for (const Vector2d& at : {Vector2d(0, 0), Vector2d(1, 0.5), Vector2d(-2, 3)}) {
        const QuadraticModel model = rows.about(at);
        EXPECT_NEAR(logEvidence(model, bestStep(model)), integral, kSameIntegral);
    }
}

TEST(Evidence, OfADisturbedModelIsTheIntegralOverTheDisturbanceToo) {
    const Rows rows;
    const VectorXd parameter = rows.columns.col(0), disturbance = rows.columns.col(1);
    constexpr double kSize = 2;
    MatrixXd columns(6, 2);
    columns << parameter, rows.measured;
    const inference::NormalEquations equations =
        inference::normalEquations(inference::productsOf(columns, disturbance), VectorXd::Constant(1, kSize));
    const QuadraticModel model{.information = equations.products.topLeftCorner(1, 1),
                               .gradient = equations.products.topRightCorner(1, 1),
                               .at = VectorXd::Zero(1),
                               .squared_residual = equations.products(1, 1),
                               .log_determinant = equations.log_determinant};
    const auto joint = [&](const Vector2d& x) {
        return rows.logPosterior({x(0), kSize * x(1)}) + 0.5 * x(1) * x(1) * (kSize * kSize - 1);
    };
    EXPECT_NEAR(logEvidence(model, bestStep(model)), logIntegral(joint, {-9, -9}, {9, 9}), kSameIntegral);
}

// The second parameter would like to be at 1.6 and may not go beyond 0.4. What is computed is the integral of a
// Gaussian about the best point that is allowed, with the curvature of the posterior and without its slope, over all
// values.
TEST(Evidence, AtABoundIsThatOfAGaussianAboutTheBestPointWithinIt) {
    const Rows rows;
    const QuadraticModel model = rows.about({0, 0});
    const Vector2d lowest(-4, -4), highest(4, 0.4);
    const Vector2d best = boundedStep(model, 0, {lowest, highest});
    ASSERT_GT(bestStep(model)(1), 0.5);
    ASSERT_EQ(best(1), 0.4);
    const MatrixXd hessian = MatrixXd::Identity(2, 2) + model.information;
    const auto gaussian = [&](const Vector2d& x) {
        return rows.logPosterior(best) - 0.5 * (x - best).dot(hessian * (x - best));
    };
    const double found = logEvidence(model, best);
    EXPECT_NEAR(found, logIntegral(gaussian, best - Vector2d(9, 9), best + Vector2d(9, 9)), kSameIntegral);
    // The parameter held where it is, and its own factor of the determinant: that of a free one.
    const double held = logEvidence(model, best) + 0.5 * std::log(hessian.determinant() / hessian(0, 0));
    const QuadraticModel first{.information = model.information.topLeftCorner(1, 1),
                               .gradient = model.gradient.head(1) - model.information.block(0, 1, 1, 1) * best(1),
                               .at = VectorXd::Zero(1),
                               .squared_residual = (rows.measured - rows.columns.col(1) * best(1)).squaredNorm()};
    EXPECT_NEAR(held, logEvidence(first, bestStep(first)) - 0.5 * best(1) * best(1), 1e-12);
}

// The prior of a parameter that may only grow is half a Gaussian, twice as high. Beside its evidence, what is computed
// at the bound is never too little: the bound cuts half of the Gaussian off, and the slope more.
TEST(Evidence, AtABoundIsNotLessThanThatOfTheOneSidedPriorAndInsideHalfOfIt) {
    const auto computed = [](double gradient, double information) {
        const QuadraticModel one{.information = MatrixXd::Constant(1, 1, information),
                                 .gradient = VectorXd::Constant(1, gradient),
                                 .at = VectorXd::Zero(1)};
        return logEvidence(one, boundedStep(one, 0, {VectorXd::Zero(1), VectorXd::Constant(1, 8)}));
    };
    // 2 int_0^inf N(x; 0, 1) exp(g x - I x^2 / 2) dx, with the error function.
    const auto exact = [](double gradient, double information) {
        const double h = 1 + information;
        return 0.5 * gradient * gradient / h - 0.5 * std::log(h) + std::log(std::erfc(-gradient / std::sqrt(2 * h)));
    };
    constexpr double kInformation = 20;
    EXPECT_NEAR(computed(0, kInformation), exact(0, kInformation), 1e-12);
    EXPECT_NEAR(computed(25, kInformation), exact(25, kInformation) - std::numbers::ln2, 1e-6);
    for (const double pull : {-2.0, -5.0, -20.0}) {
        EXPECT_GT(computed(pull, kInformation), exact(pull, kInformation));
        EXPECT_EQ(computed(pull, kInformation), computed(0, kInformation));
    }
}

TEST(Evidence, GainOfAStepIsTheDifferenceOfLogPosteriors) {
    const Rows rows;
    const Vector2d at(0.3, -0.2), step(0.7, 1.1);
    EXPECT_NEAR(gainOf(rows.about(at), step), rows.logPosterior(at + step) - rows.logPosterior(at), 1e-12);
}

}  // namespace
}  // namespace tread::evidence_test
