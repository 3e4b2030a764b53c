// How often chance leaves a gap that counts as visible, on drives drawn as the model assumes, and that a larger force
// is seen.
#include "diagnose/select/visible_gap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/math/random.h"
#include "shared/linear_drives.h"

namespace tread::diagnose_visible_gap_test {
namespace {

using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::chanceOfGap;
using diagnose::select::Fit;
using Eigen::Index;
using Eigen::MatrixXd;
using linear_drives::LinearDrive;
using linear_drives::normals;

constexpr int kDrives = 3;
constexpr Index kRows = 40, kNuisances = 4, kForces = 6;

// Drives of one car without an effect, with forces so many times the usual size.
std::vector<LinearDrive> drawn(double forces, Random& random) {
    const MatrixXd car = normals(kNuisances, 1, random);
    std::vector<LinearDrive> all;
    for (int d = 0; d < kDrives; ++d) {
        LinearDrive drive{
            normals(kRows, kNuisances, random), normals(kRows, 1, random), {}, normals(kRows, kForces, random)};
        drive.measured = normals(kRows, 1, random) + drive.nuisances * car +
                         forces * drive.disturbances * normals(kForces, 1, random);
        all.push_back(std::move(drive));
    }
    return all;
}

double chanceIn(const std::vector<LinearDrive>& drives) {
    const Problem problem = linear_drives::problemOf(drives);
    const Calibration car = linear_drives::calibrationOf(problem, drives);
    const Fit fit = linear_drives::fitOf(car, {});
    return chanceOfGap(car, fit, fit.rows);
}

// The probability is an upper bound for several channels and drives together: no more draws than that share lie below a
// limit, and not many fewer.
TEST(VisibleGap, IsAsRareAsItSaysWhereThereIsNothing) {
    Random random(3);
    constexpr int kDraws = 4000;
    std::vector<double> chances;
    for (int i = 0; i < kDraws; ++i) chances.push_back(chanceIn(drawn(1, random)));
    for (const double limit : {0.02, 0.1}) {
        const auto below = static_cast<double>(
            std::count_if(chances.begin(), chances.end(), [&](double chance) { return chance < limit; }));
        const double deviation = std::sqrt(limit * kDraws);
        EXPECT_LE(below, limit * kDraws + 3 * deviation) << limit;
        EXPECT_GE(below, 0.5 * limit * kDraws) << limit;
    }
}

TEST(VisibleGap, IsSeenWhereForcesAreManyTimesTheUsual) {
    Random random(4);
    for (int i = 0; i < 100; ++i) EXPECT_LT(chanceIn(drawn(12, random)), 1e-3);
}

}  // namespace
}  // namespace tread::diagnose_visible_gap_test
