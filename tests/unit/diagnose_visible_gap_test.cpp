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

using diagnose::model::Disturbed;
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

// Drives of one car without an effect, with forces so many times the usual size, which cause so much motion.
std::vector<LinearDrive> drawn(double forces, Random& random, double motion = 1) {
    const MatrixXd car = normals(kNuisances, 1, random);
    std::vector<LinearDrive> all;
    for (int d = 0; d < kDrives; ++d) {
        LinearDrive drive{normals(kRows, kNuisances, random),
                          normals(kRows, 1, random),
                          {},
                          motion * normals(kRows, kForces, random),
                          std::vector<Disturbed>(kForces, Disturbed::lateral)};
        drive.measured = normals(kRows, 1, random) + drive.nuisances * car +
                         forces * drive.disturbances * normals(kForces, 1, random);
        all.push_back(std::move(drive));
    }
    return all;
}

// The same with errors of the readings of two channels, so many times the usual size.
std::vector<LinearDrive> misread(std::vector<LinearDrive> drives, double errors, Disturbed kind, Random& random) {
    constexpr Index kOfChannel = kRows / 8;
    for (LinearDrive& drive : drives) {
        MatrixXd both = MatrixXd::Zero(kRows, 2);
        for (const Index channel : {0, 1})
            both.col(channel).segment(channel * kOfChannel, kOfChannel) = 0.5 * normals(kOfChannel, 1, random);
        drive.measured += errors * both * normals(2, 1, random);
        MatrixXd all(kRows, kForces + 2);
        all << drive.disturbances, both;
        drive.disturbances = all;
        drive.kinds.resize(kForces + 2, kind);
    }
    return drives;
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
    std::vector<double> chances, of_readings;
    for (int i = 0; i < kDraws; ++i) {
        chances.push_back(chanceIn(drawn(1, random)));
        of_readings.push_back(chanceIn(misread(drawn(1, random), 1, Disturbed::acceleration_scale, random)));
    }
    for (const double limit : {0.02, 0.1}) {
        const auto below = [&](const std::vector<double>& all) {
            return static_cast<double>(
                std::count_if(all.begin(), all.end(), [&](double chance) { return chance < limit; }));
        };
        const double most = limit * kDraws + 3 * std::sqrt(limit * kDraws);
        EXPECT_LE(below(chances), most) << limit;
        EXPECT_GE(below(chances), 0.5 * limit * kDraws) << limit;
        EXPECT_LE(below(of_readings), most) << limit;
    }
}

TEST(VisibleGap, IsSeenWhereForcesAreManyTimesTheUsual) {
    Random random(4);
    for (int i = 0; i < 100; ++i) EXPECT_LT(chanceIn(drawn(12, random)), 1e-3);
}

// All channels show the motion, which is large compared with the error of two of them. It is seen because the others do
// not show it, but not if it may be a force.
TEST(VisibleGap, OfAnInstrumentIsSeenThroughTheMotionOfTheCar) {
    constexpr int kDraws = 100;
    for (const Disturbed kind : {Disturbed::acceleration_scale, Disturbed::lateral}) {
        Random random(5);
        int seen = 0;
        for (int i = 0; i < kDraws; ++i)
            seen += chanceIn(misread(drawn(1, random, 10), 12, kind, random)) < 0.02 ? 1 : 0;
        if (kind == Disturbed::acceleration_scale) {
            EXPECT_GT(seen, 0.9 * kDraws);
        } else {
            EXPECT_LT(seen, 0.1 * kDraws);
        }
    }
}

// Adds an effect that is wrong by another share in each drive. It resembles an error of readings, if the drives have
// one.
void addEffect(std::vector<LinearDrive>& drives, double error, Random& random) {
    for (LinearDrive& drive : drives) {
        drive.effects = 8 * normals(kRows, 1, random);
        if (drive.disturbances.cols() > kForces) drive.effects += 40 * drive.disturbances.col(kForces);
        drive.measured += (1 + error * random.normal()) * drive.effects;
    }
}

double chanceWithEffect(const std::vector<LinearDrive>& drives, double error) {
    const Problem problem = linear_drives::problemOf(drives);
    Calibration car = linear_drives::calibrationOf(problem, drives);
    car.structure_error = error;
    const Fit fit = linear_drives::fitOf(car, {0});
    return chanceOfGap(car, fit, fit.rows);
}

TEST(VisibleGap, IsNoLargerThanTheErrorsOfSignaturesMakeIt) {
    constexpr double kError = 0.5;
    constexpr int kDraws = 400;
    Random random(6);
    for (const bool readings : {false, true}) {
        int seen = 0, seen_if_exact = 0;
        for (int i = 0; i < kDraws; ++i) {
            std::vector<LinearDrive> drives = drawn(1, random);
            if (readings) drives = misread(std::move(drives), 1, Disturbed::acceleration_scale, random);
            addEffect(drives, kError, random);
            seen += chanceWithEffect(drives, kError) < 0.02 ? 1 : 0;
            seen_if_exact += chanceWithEffect(drives, 0) < 0.02 ? 1 : 0;
        }
        // If one squared normal number is most of a gap, two moments understate its tail by a factor of two.
        const double expected = 2 * 0.02 * kDraws;
        EXPECT_LE(seen, expected + 3 * std::sqrt(expected)) << readings;
        EXPECT_GE(seen_if_exact, 0.5 * kDraws) << readings;
    }
}

}  // namespace
}  // namespace tread::diagnose_visible_gap_test
