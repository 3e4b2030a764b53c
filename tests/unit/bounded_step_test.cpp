// The best step between bounds, against conditions that any minimum of a convex problem meets, and by hand.
#include "inference/bounded_step.h"

#include <gtest/gtest.h>

#include "base/math/random.h"
#include "inference/laplace.h"

namespace tread::bounded_step_test {
namespace {

using inference::boundedStep;
using inference::QuadraticModel;

// How much more each parameter would like to move.
Eigen::VectorXd pull(const QuadraticModel& model, const Eigen::VectorXd& step) {
    return model.gradient - model.at - step - model.information * step;
}

TEST(BoundedStep, LeavesNothingToGainWithinTheBounds) {
    Random random(7);
    constexpr Eigen::Index kSize = 6;
    for (int trial = 0; trial < 200; ++trial) {
        Eigen::MatrixXd rows(9, kSize);
        Eigen::VectorXd gradient(kSize), x(kSize), lowest(kSize), highest(kSize);
        for (double& one : rows.reshaped()) one = random.normal();
        for (Eigen::Index i = 0; i < kSize; ++i) {
            gradient(i) = 5 * random.normal();
            x(i) = 0.3 * random.normal();
            lowest(i) = x(i) - (random.uniform() < 0.3 ? 0 : random.uniform());
            highest(i) = x(i) + random.uniform();
        }
        const QuadraticModel model{.information = rows.transpose() * rows, .gradient = gradient, .at = x};
        const Eigen::VectorXd step = boundedStep(model, 0, {lowest, highest});
        const Eigen::VectorXd left = pull(model, step);
        for (Eigen::Index i = 0; i < kSize; ++i) {
            const double at = x(i) + step(i);
            EXPECT_GE(at, lowest(i) - 1e-12);
            EXPECT_LE(at, highest(i) + 1e-12);
            const bool may_fall = at > lowest(i) + 1e-9, may_rise = at < highest(i) - 1e-9;
            EXPECT_GE(left(i), may_fall ? -1e-7 : -1e9) << "trial " << trial;
            EXPECT_LE(left(i), may_rise ? 1e-7 : 1e9) << "trial " << trial;
        }
    }
}

// A delay and a lag that look nearly alike, both from zero upwards: the free optimum is one of them far up and the
// other below zero. Cutting that off at zero would take a step that makes things worse.
TEST(BoundedStep, DoesNotGoUphillWhenAPartnerMeetsItsBound) {
    Eigen::MatrixXd information(2, 2);
    information << 1000, 990, 990, 1000;
    const Eigen::Vector2d gradient(1000, 900), zero(0, 0), far(10, 10);
    const Eigen::VectorXd step = boundedStep({information, gradient, zero}, 0, {zero, far});
    EXPECT_NEAR(step(0), 1000.0 / 1001, 1e-12);
    EXPECT_EQ(step(1), 0);
}

}  // namespace
}  // namespace tread::bounded_step_test
