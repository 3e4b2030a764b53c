// Squared Birge ratios by channel, against the covariance written out.
#include "diagnose/model/birge_ratios.h"

#include <gtest/gtest.h>

#include "shared/linear_drives.h"

namespace tread::diagnose_birge_ratios_test {
namespace {

using diagnose::model::BirgeRatios;
using diagnose::model::ChannelSquares;
using diagnose::model::Problem;
using diagnose::model::Rows;
using diagnose::model::Uncertainty;
using linear_drives::LinearDrive;
using linear_drives::MatrixXd;
using linear_drives::VectorXd;

// One drive of eight rows, the first four of which are the channel `shaken`, with twice the noise that is told.
struct TwoChannels {
    explicit TwoChannels(const MatrixXd& disturbances)
        : drives{{MatrixXd(8, 0), MatrixXd(8, 0), VectorXd{{2, -2, 2, 2, 1, -1, 1, 1}}, disturbances, {}}},
          problem(linear_drives::problemOf(drives)),
          uncertainty(linear_drives::uncertaintyOf(drives, 3)),
          squares(channels(), uncertainty, uncertainty.sizes),
          ratios(problem.drives, uncertainty, squares, Rows{VectorXd::Zero(8)}) {}

    diagnose::model::Drives channels() {
        problem.drives[0].channels = {
            {.name = "shaken", .measured = {}, .first_row = 0, .times = std::vector<double>(4)},
            {.name = "still", .measured = {}, .first_row = 4, .times = std::vector<double>(4)}};
        return problem.drives;
    }
    double between(const VectorXd& difference) const {
        return ratios.between(Rows{difference}, Rows{VectorXd::Zero(8)});
    }

    std::vector<LinearDrive> drives;
    Problem problem;
    Uncertainty uncertainty;
    ChannelSquares squares;
    BirgeRatios ratios;
};

TEST(BirgeRatios, WeakenOnlyEvidenceThatStandsOnTheirChannel) {
    const TwoChannels two(MatrixXd(8, 0));
    EXPECT_DOUBLE_EQ(two.between(VectorXd{{1, 0, 2, 0, 0, 0, 0, 0}}), 4);
    EXPECT_DOUBLE_EQ(two.between(VectorXd{{0, 0, 0, 0, 1, 0, 0, 3}}), 1);
    EXPECT_DOUBLE_EQ(two.between(VectorXd{{1, 0, 0, 0, 0, 0, 0, 1}}), 2.5);
    EXPECT_DOUBLE_EQ(two.between(VectorXd::Zero(8)), 1) << "the same model";
}

TEST(BirgeRatios, AreThoseBesideTheRemainder) {
    const VectorXd pushed{{1, 0, 0, 1, 1, 0, 1, 0}};
    const TwoChannels two(pushed);
    const MatrixXd metric = (MatrixXd::Identity(8, 8) + 9 * pushed * pushed.transpose()).inverse();
    const auto shares = [&](const VectorXd& off) {
        const VectorXd each = off.cwiseProduct(metric * off);
        return std::pair{each.head(4).sum(), each.tail(4).sum()};
    };
    const auto [shaken, still] = shares(two.drives[0].measured);
    const VectorXd difference{{0, 1, 1, 0, 0, 1, 0, 2}};
    const auto [first, second] = shares(difference);
    ASSERT_GT(shaken / 4, 1);
    EXPECT_NEAR(two.between(difference), (first * shaken / 4 + second * std::max(1.0, still / 4)) / (first + second),
                1e-12);
}

}  // namespace
}  // namespace tread::diagnose_birge_ratios_test
