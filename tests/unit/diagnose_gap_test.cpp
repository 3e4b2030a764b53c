// The measure of a gap, by hand.
#include "diagnose/model/gap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::diagnose_gap_test {
namespace {

using diagnose::model::comparedRows;
using diagnose::model::Disturbed;
using diagnose::model::floorOf;
using diagnose::model::levelOf;
using diagnose::model::Rows;
using diagnose::model::squaredGap;
using diagnose::model::squaredGaps;
using diagnose::model::Uncertainty;
using recording::RecordedDrive;

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSame = 1e-12;

// Two drives, of four and two rows. The last row of the first is not compared.
struct Gap {
    std::vector<RecordedDrive> drives = std::vector<RecordedDrive>(2);
    Uncertainty uncertainty;
    Rows rows{VectorXd{{0.5, 0, 1, 0}}, VectorXd::Zero(2)};

    Gap() {
        drives[0].measured = VectorXd{{1, 2, 3, 1e6}};
        drives[1].measured = VectorXd{{-4, 0}};
        uncertainty.noise = {{.deviation = VectorXd{{0.1, 0.1, 0.1, kInfinity}}, .ends = {4}},
                             {.deviation = VectorXd{{2, 2}}, .ends = {2}}};
        uncertainty.disturbing.resize(2);
        uncertainty.disturbing[0].kinds = {Disturbed::lateral, Disturbed::lateral_error};
        // Over the noise; the last column by the speed at the start, 0.1 m/s.
        uncertainty.directions = {MatrixXd{{0.5, 3, 0}, {1, 3, 0}, {0, 3, 20}, {0, 0, 0}}, MatrixXd{{0}, {10}}};
        uncertainty.sizes.fill(2);
    }
};

TEST(Gap, FloorIsThatOfNoiseAndUsualDisturbances) {
    const Gap gap;
    const VectorXd floor = floorOf(gap.uncertainty, 0);
    EXPECT_NEAR(floor(0), 0.1 * std::sqrt(1 + 0.25), kSame) << "of the usual size, and without errors of forces";
    EXPECT_NEAR(floor(1), 0.1 * std::sqrt(1 + 1), kSame);
    EXPECT_NEAR(floor(2), 0.1 * std::sqrt(1 + 4), kSame) << "of the speed at the start";
    EXPECT_EQ(floor(3), kInfinity);
}

TEST(Gap, IsTheSumOfSquaresOverTheFloor) {
    const Gap gap;
    const double first = 0.25 / 0.0125 + 4 / 0.02 + 4 / 0.05, second = 16 / 4.0;
    EXPECT_NEAR(squaredGap(gap.drives, gap.uncertainty, gap.rows[0], 0), first, 1e-9);
    const std::vector<double> both = squaredGaps(gap.drives, gap.uncertainty, gap.rows);
    ASSERT_EQ(both.size(), 2u);
    EXPECT_NEAR(both[0], first, 1e-9);
    EXPECT_NEAR(both[1], second, 1e-9);
    EXPECT_EQ(comparedRows(gap.uncertainty, 0), 3);
    EXPECT_EQ(comparedRows(gap.uncertainty, 1), 2);
    EXPECT_NEAR(levelOf(gap.drives, gap.uncertainty, gap.rows), std::sqrt((first + second) / 5), 1e-9);
}

TEST(Gap, DoesNotDependOnTheSizesThatAModelLeaves) {
    Gap gap;
    const double before = squaredGap(gap.drives, gap.uncertainty, gap.rows[0], 0);
    gap.uncertainty.sizes.fill(30);
    EXPECT_EQ(squaredGap(gap.drives, gap.uncertainty, gap.rows[0], 0), before);
}

}  // namespace
}  // namespace tread::diagnose_gap_test
