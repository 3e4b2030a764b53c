// Sizes of the remainder: the maximum of the evidence, against a search over all sizes with the density of the rows
// from their full covariance.
#include "diagnose/model/remainder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math/random.h"
#include "diagnose/select/calibration.h"
#include "shared/linear_drives.h"
#include "shared/most_probable_sizes.h"

namespace tread::diagnose_remainder_test {
namespace {

using diagnose::model::changeOf;
using diagnose::model::Disturbed;
using diagnose::model::improvedSizes;
using diagnose::model::kLargePrior;
using diagnose::model::kOrdinaryPrior;
using diagnose::model::kWidePrior;
using diagnose::model::logPrior;
using diagnose::model::Problem;
using diagnose::model::Sizes;
using diagnose::model::SizesPrior;
using diagnose::model::Uncertainty;
using diagnose::select::Calibration;
using diagnose::select::Fit;
using diagnose::select::sizesWithAllFree;
using linear_drives::LinearDrive;
using linear_drives::logDensity;
using linear_drives::mostProbableSizes;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Disturbed kFirst = Disturbed::yaw, kSecond = Disturbed::lateral_error;

VectorXd normals(Index count, double size, Random& random) {
    VectorXd all(count);
    for (double& one : all) one = size * random.normal();
    return all;
}

// Two drives of twelve rows: a nuisance, an effect, and disturbances of two kinds with the given sizes.
struct Remaining {
    std::vector<LinearDrive> drives;
    Problem problem;
    Calibration car;

    Remaining(double first, double second, std::uint64_t seed)
        : drives(drawn(first, second, seed)),
          problem(linear_drives::problemOf(drives)),
          car(linear_drives::calibrationOf(problem, drives)) {}

    static std::vector<LinearDrive> drawn(double first, double second, std::uint64_t seed) {
        Random random(seed);
        std::vector<LinearDrive> all;
        for (int d = 0; d < 2; ++d) {
            LinearDrive drive{normals(12, 0.8, random), normals(12, 1, random), {}, MatrixXd(12, 9), {}};
            drive.disturbances = normals(12 * 9, 1, random).reshaped(12, 9);
            drive.kinds.assign(9, kFirst);
            std::fill(drive.kinds.begin() + 5, drive.kinds.end(), kSecond);
            drive.measured = 0.7 * drive.nuisances - 0.9 * drive.effects + normals(12, 1, random) +
                             drive.disturbances.leftCols(5) * normals(5, first, random) +
                             drive.disturbances.rightCols(4) * normals(4, second, random);
            all.push_back(std::move(drive));
        }
        return all;
    }

    // After so many steps that they no longer change, the parameters at their best point each time.
    Sizes settled(const std::vector<std::size_t>& effects, const SizesPrior& prior) const {
        Sizes sizes = car.uncertainty.sizes;
        for (int i = 0; i < 200; ++i) {
            const Fit fit = linear_drives::fitOf(car, effects, sizes);
            sizes = improvedSizes(car.uncertainty, fit.products, sizes, 1, prior);
        }
        return sizes;
    }
    void expectMostProbable(const std::vector<std::size_t>& effects, const SizesPrior& prior) const {
        const auto density = [&](const Sizes& sizes) { return logDensity(drives, effects, sizes); };
        const Sizes expected = mostProbableSizes(density, kFirst, kSecond, prior), found = settled(effects, prior);
        EXPECT_LT(changeOf(found, expected), 0.01) << found[placeOf(kFirst)] << ", " << found[placeOf(kSecond)] << "; "
                                                   << expected[placeOf(kFirst)] << ", " << expected[placeOf(kSecond)];
        for (const Disturbed kind : {Disturbed::lateral, Disturbed::roll, Disturbed::yaw_error})
            EXPECT_EQ(found[placeOf(kind)], 1) << nameOf(kind) << " does not act";
    }
};

TEST(SizesOfTheRemainder, ConvergeToTheMaximumOfTheEvidenceAndTheirPrior) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Remaining remaining(2.5, 0.7, seed);
        for (const std::vector<std::size_t>& effects : {std::vector<std::size_t>{}, {0}})
            for (const SizesPrior& prior : {kWidePrior, kLargePrior, kOrdinaryPrior})
                remaining.expectMostProbable(effects, prior);
    }
}

// Two maxima of the same evidence, one with a stronger penalty: the stronger one leaves less to penalise.
TEST(SizesOfTheRemainder, AreHeldBackByTheirPrior) {
    const Remaining remaining(6, 1, 4);
    const auto above = [&](const SizesPrior& prior) {
        double sum = 0;
        for (const double size : remaining.settled({}, prior)) sum += std::pow(std::max(0.0, std::log(size)), 2);
        return sum;
    };
    EXPECT_GT(above(kLargePrior), 1.05 * above(kOrdinaryPrior));
    EXPECT_GT(above(kOrdinaryPrior), 0.1);
}

TEST(SizesOfTheRemainder, HavePriorsThatAreNormalInTheirLogarithms) {
    Sizes sizes;
    sizes.fill(1);
    for (const SizesPrior& prior : {kWidePrior, kLargePrior, kOrdinaryPrior}) EXPECT_EQ(logPrior(sizes, prior), 0);
    sizes[0] = 3, sizes[6] = 0.2;
    const double up = std::pow(std::log(3), 2), down = std::pow(std::log(0.2), 2);
    EXPECT_NEAR(logPrior(sizes, kWidePrior), -0.5 * (up + down), 1e-12);
    EXPECT_NEAR(logPrior(sizes, kLargePrior), -0.5 * up, 1e-12) << "sizes below the usual ones are free";
    EXPECT_NEAR(logPrior(sizes, kOrdinaryPrior), -0.5 * up / 0.25, 1e-12);
    sizes[placeOf(Disturbed::rate_reading)] = 3;
    EXPECT_NEAR(logPrior(sizes, kLargePrior), -0.5 * (up + up / 0.25), 1e-12) << "instruments are better known";
    Sizes other = sizes;
    other[6] = 0.1;
    EXPECT_NEAR(changeOf(sizes, other), std::log(2), 1e-12);
}

constexpr Index kRows = 300;
constexpr double kPush = 2;  // times the noise, of what an impulse of the usual size does to its row

// Rows of noise and of a disturbance `size` times the usual one, an impulse each.
VectorXd drawn(double size, std::uint64_t seed) {
    Random random(seed);
    return normals(kRows, std::sqrt(1 + kPush * kPush * size * size), random);
}

struct Sized {
    std::vector<LinearDrive> drives;
    Problem problem;
    Uncertainty uncertainty;

    // A column that is free, of the size of what the effects do, may be in the rows.
    Sized(VectorXd rows, const VectorXd& effect, double by)
        : drives{{MatrixXd(kRows, 0), effect, rows + by * effect, kPush * MatrixXd::Identity(kRows, kRows),
                  std::vector<Disturbed>(kRows, Disturbed::yaw)}},
          problem(linear_drives::problemOf(drives)),
          uncertainty(linear_drives::uncertaintyOf(drives, 1)) {}

    double found() const {
        MatrixXd columns(kRows, 2);
        columns << drives.front().effects, problem.drives.front().measured;
        const Sizes sizes =
            sizesWithAllFree(problem, uncertainty, {diagnose::model::productsOf(uncertainty, 0, columns)});
        return sizes[placeOf(Disturbed::yaw)];
    }
};

// What is maximised, in scalars: rows are independent, of variance 1 + (push size)^2.
double merit(const VectorXd& rows, double log_size) {
    const double variance = 1 + std::pow(kPush * std::exp(log_size), 2);
    return -0.5 * (rows.squaredNorm() / variance + static_cast<double>(rows.size()) * std::log(variance)) -
           0.5 * log_size * log_size;
}

TEST(SizesOfTheRemainder, OfManyRowsAreThoseThatDrewThem) {
    for (const double size : {0.5, 1.0, 2.3, 9.0}) {
        const VectorXd rows = drawn(size, 8);
        double best = 0;
        for (double log_size = -3; log_size <= 3; log_size += 1e-3)
            if (merit(rows, log_size) > merit(rows, best)) best = log_size;
        EXPECT_NEAR(std::log(Sized(rows, VectorXd::Zero(kRows), 0).found()), best, 0.05) << size;
        // Standard deviation of the logarithm that so many rows leave: about one over the root of twice their count.
        const double signal = std::pow(kPush * size, 2), sd = (1 + signal) / signal / std::sqrt(2.0 * kRows);
        EXPECT_NEAR(best, std::log(size), 3 * sd) << "with the pull of the prior";
        const Sized fixed(rows, VectorXd::Zero(kRows), 0);
        const Sizes there = sizesAt(fixed.problem.drives, fixed.uncertainty, {VectorXd::Zero(kRows)}, 1);
        EXPECT_NEAR(std::log(there[placeOf(Disturbed::yaw)]), best, 0.1) << "with nothing free";
    }
}

// What an effect does is free, and not taken for a disturbance.
TEST(SizesOfTheRemainder, DoNotGrowByWhatAnEffectExplains) {
    VectorXd effect(kRows);
    for (Index i = 0; i < kRows; ++i) effect(i) = 3 * std::sin(0.1 * static_cast<double>(i));
    const VectorXd rows = drawn(1, 8);
    const double without = Sized(rows, effect, 0).found();
    EXPECT_NEAR(Sized(rows, effect, 2).found(), without, 0.05 * without);
    EXPECT_GT(Sized(rows + 2 * effect, VectorXd::Zero(kRows), 0).found(), 1.5 * without) << "but is without its column";
}

}  // namespace
}  // namespace tread::diagnose_remainder_test
