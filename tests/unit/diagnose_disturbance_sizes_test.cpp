// Sizes of disturbances, found again in rows that were drawn with them.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "diagnose/select/calibration.h"
#include "shared/linear_drives.h"

namespace tread {
namespace {

using diagnose::model::Disturbed;
using diagnose::model::DriveProducts;
using diagnose::model::Drives;
using diagnose::model::Problem;
using diagnose::model::Sizes;
using diagnose::model::Uncertainty;
using diagnose::select::disturbanceSizes;
using linear_drives::LinearDrive;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kRows = 300;
constexpr double kPush = 2;  // times the noise, of what an impulse of the usual size does to its row

// Rows of noise and of a disturbance `size` times the usual one, an impulse each.
VectorXd drawn(double size, std::uint64_t seed) {
    Random random(seed);
    VectorXd rows(kRows);
    for (double& one : rows) one = std::sqrt(1 + kPush * kPush * size * size) * random.normal();
    return rows;
}

struct Sized {
    std::vector<LinearDrive> drives;
    Problem problem;
    Uncertainty uncertainty;

    // A column that is free, of the size of what the effects do, may be in the rows.
    Sized(VectorXd rows, Disturbed kind, const VectorXd& effect, double by)
        : drives{{MatrixXd(kRows, 0), effect, rows + by * effect, kPush * MatrixXd::Identity(kRows, kRows)}},
          problem(linear_drives::problemOf(drives)),
          uncertainty(linear_drives::uncertaintyOf(drives, 1, kind)) {}

    Sizes found() const {
        MatrixXd columns(kRows, 2);
        columns << drives.front().effects, problem.drives.front().measured;
        return disturbanceSizes(problem.drives, uncertainty, {diagnose::model::productsOf(uncertainty, 0, columns)});
    }
};

// What is maximised, in scalars: rows are independent, of variance 1 + (push size)^2.
double merit(const VectorXd& rows, double log_size) {
    const double variance = 1 + std::pow(kPush * std::exp(log_size), 2);
    return -0.5 * (rows.squaredNorm() / variance + static_cast<double>(rows.size()) * std::log(variance)) -
           0.5 * std::pow(log_size / 0.5, 2);
}

TEST(DisturbanceSizes, AreThoseOfTheLargestEvidence) {
    for (const double size : {0.5, 1.0, 1.7, 2.3}) {
        const VectorXd rows = drawn(size, 8);
        double best = 0, most = -1e18;
        for (double log_size = -std::log(3.0); log_size <= std::log(3.0); log_size += 1e-3)
            if (merit(rows, log_size) > most) most = merit(rows, log_size), best = log_size;
        const double found = std::log(Sized(rows, Disturbed::yaw, VectorXd::Zero(kRows), 0).found()[2]);
        // Steps of the logarithm begin at 0.6 and are halved at most five times.
        EXPECT_NEAR(found, best, 0.15) << size;
        EXPECT_LT(most - merit(rows, found), 3) << "nats that the search leaves";
        // Standard deviation of the logarithm that so many rows leave: about one over the root of twice their count.
        const double signal = std::pow(kPush * size, 2), sd = (1 + signal) / signal / std::sqrt(2.0 * kRows);
        EXPECT_NEAR(best, std::log(size), 3 * sd + 0.05) << "with the pull of the prior";
    }
}

TEST(DisturbanceSizes, OfKindsThatTheRowsDoNotShowStayTheUsualOnes) {
    const Sizes found = Sized(drawn(1.7, 9), Disturbed::roll, VectorXd::Zero(kRows), 0).found();
    for (const Disturbed kind : diagnose::model::kDisturbedKinds) {
        if (kind == Disturbed::roll) EXPECT_GT(found[placeOf(kind)], 1.3);
        else EXPECT_EQ(found[placeOf(kind)], 1) << nameOf(kind);
    }
}

TEST(DisturbanceSizes, AreNeverMoreThanThreeTimesTheUsualOrAThird) {
    const double small = Sized(drawn(0, 8), Disturbed::yaw, VectorXd::Zero(kRows), 0).found()[2];
    const double large = Sized(drawn(20, 8), Disturbed::yaw, VectorXd::Zero(kRows), 0).found()[2];
    EXPECT_GE(small, 1 / 3.0);
    EXPECT_LT(small, 0.5);
    EXPECT_LE(large, 3);
    EXPECT_GT(large, 2.5);
}

// What an effect does is free, and not taken for a disturbance.
TEST(DisturbanceSizes, DoNotGrowByWhatAnEffectExplains) {
    VectorXd effect(kRows);
    for (Index i = 0; i < kRows; ++i) effect(i) = 3 * std::sin(0.1 * static_cast<double>(i));
    const VectorXd rows = drawn(1, 8);
    const double without = Sized(rows, Disturbed::yaw, effect, 0).found()[2];
    EXPECT_NEAR(Sized(rows, Disturbed::yaw, effect, 2).found()[2], without, 0.05 * without);
    EXPECT_GT(Sized(rows + 2 * effect, Disturbed::yaw, VectorXd::Zero(kRows), 0).found()[2], 1.5 * without)
        << "but is without its column";
}

}  // namespace
}  // namespace tread
