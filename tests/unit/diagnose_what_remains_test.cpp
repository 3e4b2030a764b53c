// Whether a remainder is larger than ordinary, against the densities of the rows under both priors of sizes.
#include "diagnose/select/what_remains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "base/math/random.h"
#include "diagnose/settings.h"
#include "shared/linear_drives.h"

namespace tread::diagnose_what_remains_test {
namespace {

using diagnose::model::Disturbed;
using diagnose::model::kLargePrior;
using diagnose::model::kOrdinaryPrior;
using diagnose::model::Problem;
using diagnose::model::Sizes;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Remains;
using diagnose::select::whatRemains;
using linear_drives::LinearDrive;
using linear_drives::logDensity;
using linear_drives::normals;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Disturbed kFirst = Disturbed::lateral, kSecond = Disturbed::yaw_error;

Sizes ordinarySizes() {
    Sizes sizes;
    sizes.fill(1);
    return sizes;
}

// Two drives of a car with an effect and disturbances of these sizes.
std::vector<LinearDrive> drawn(double first, double second, std::uint64_t seed = 11) {
    Random random(seed);
    std::vector<LinearDrive> all;
    for (int d = 0; d < 2; ++d) {
        LinearDrive drive{normals(14, 1, random), normals(14, 1, random), {}, normals(14, 8, random), {}};
        drive.kinds.assign(8, kFirst);
        std::fill(drive.kinds.begin() + 4, drive.kinds.end(), kSecond);
        const VectorXd noise = normals(14, 1, random), of_first = normals(4, 1, random),
                       of_second = normals(4, 1, random);
        drive.measured = noise + 1.5 * drive.effects + first * drive.disturbances.leftCols(4) * of_first +
                         second * drive.disturbances.rightCols(4) * of_second;
        all.push_back(std::move(drive));
    }
    return all;
}

// Logarithm of the Bayes factor, integrated over both sizes on a grid, with rows of their full covariance. Half of
// each prior lies above the usual size; below it, both are the same.
double bayesFactor(const std::vector<LinearDrive>& drives) {
    constexpr double kStep = 0.1, kLowest = -3.5, kHighest = 4;  // of the logarithm of a size
    const auto prior = [](double log_size, double spread) {
        const double within = log_size > 0 ? spread : kLargePrior.spread;
        return std::exp(-0.5 * std::pow(log_size / within, 2)) / within;
    };
    struct Point {
        double log_density, large, ordinary;
    };
    std::vector<Point> points;
    for (double a = kLowest; a < kHighest; a += kStep) {
        for (double b = kLowest; b < kHighest; b += kStep) {
            Sizes sizes = ordinarySizes();
            sizes[placeOf(kFirst)] = std::exp(a), sizes[placeOf(kSecond)] = std::exp(b);
            points.push_back({logDensity(drives, {0}, sizes),
                              prior(a, kLargePrior.spread) * prior(b, kLargePrior.spread),
                              prior(a, kOrdinaryPrior.spread) * prior(b, kOrdinaryPrior.spread)});
        }
    }
    double most = -1e300, large = 0, ordinary = 0;
    for (const Point& one : points) most = std::max(most, one.log_density);
    for (const Point& one : points) {
        large += std::exp(one.log_density - most) * one.large;
        ordinary += std::exp(one.log_density - most) * one.ordinary;
    }
    return std::log(large / ordinary);
}

Remains remainsOf(const std::vector<LinearDrive>& drives, double structure_error = 0) {
    const Problem problem = linear_drives::problemOf(drives);
    Calibration car = linear_drives::calibrationOf(problem, drives);
    car.structure_error = structure_error;
    const Candidate model{.effects = {0}, .fit = linear_drives::resizedFitOf(car, {0}), .fitted = true};
    return whatRemains(car, model, {model.fit.at, model.fit.rows});
}

bool seen(const Remains& remains) {
    return remains.probability() >= diagnose::kSettings.sure;
}

// The Gaussian in the logarithms of the sizes that (D33) puts in place of the integral is an approximation: it errs by
// this (root mean square over draws), or by a tenth of the evidence.
constexpr double kOfApproximation = 0.6;  // nats

TEST(WhatRemains, IsBeyondOrdinaryByTheEvidenceOfLargerSizes) {
    constexpr int kDraws = 4;
    for (const auto& [first, second] : {std::pair{1.0, 1.0}, {2.0, 0.1}, {4.0, 1.0}, {0.2, 9.0}, {12.0, 12.0}}) {
        double squares = 0, evidence = 0;
        Remains found;
        for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
            const std::vector<LinearDrive> drives = drawn(first, second, seed);
            found = remainsOf(drives);
            const double exact = bayesFactor(drives);
            squares += std::pow(found.beyond_ordinary - exact, 2) / kDraws, evidence += exact / kDraws;
        }
        EXPECT_LE(std::sqrt(squares), std::max(kOfApproximation, 0.1 * evidence)) << first << ", " << second;
        const double nats = std::max(found.visible() ? found.beyond_ordinary : 0, found.strain);
        EXPECT_NEAR(found.probability(), 1 / (1 + 9 * std::exp(-nats)), 1e-12);
        EXPECT_EQ(seen(found), nats >= std::log(81)) << "odds of 9 to 1 after 1 to 9";
        EXPECT_TRUE(found.law.follows.empty());
    }
}

TEST(WhatRemains, IsSeenWhereItIsManyTimesTheUsual) {
    EXPECT_TRUE(seen(remainsOf(drawn(12, 12))));
    EXPECT_FALSE(seen(remainsOf(drawn(1, 1))));
}

// What an effect changes may be wrong by more than what remains.
TEST(WhatRemains, MayBeTheErrorOfASignature) {
    const std::vector<LinearDrive> drives = drawn(12, 12);
    const double exact = remainsOf(drives).beyond_ordinary;
    double largest = 0;
    for (const LinearDrive& drive : drives) largest = std::max(largest, std::pow(1.5, 2) * drive.effects.squaredNorm());
    double before = 2 * largest;
    for (const double error : {0.05, 0.5, 5.0}) {
        // The error may lie along the remainder in each drive, where its square is at most that of the effect. The
        // larger it is, the more counts the drive in which the effect is smallest.
        const double divisor = exact / remainsOf(drives, error).beyond_ordinary;
        const double of_effect = (divisor - 1) / (error * error);
        EXPECT_GT(of_effect, 0);
        EXPECT_LT(of_effect, before);
        before = of_effect;
    }
    EXPECT_FALSE(seen(remainsOf(drives, 50)));
}

// Without disturbances, the error of the signature along what a number changes has a closed form.
TEST(WhatRemains, OfANumberThatMovedMayBeTheErrorOfASignature) {
    constexpr double kMoved = 6, kEffect = 40, kError = 0.05;
    std::vector<LinearDrive> drives = drawn(0, 0);
    for (LinearDrive& drive : drives) drive.disturbances.resize(14, 0), drive.kinds.clear();
    const Problem problem = linear_drives::problemOf(drives);
    Calibration car = linear_drives::calibrationOf(problem, drives);
    Candidate model{.effects = {0}, .fit = linear_drives::resizedFitOf(car, {0}), .fitted = true};
    model.fit.at(model.fit.free[0]) = kMoved, model.fit.at(model.fit.free[1]) = kEffect;
    car.structure_error = 0;
    const double strain = whatRemains(car, model, {model.fit.at, model.fit.rows}).strain;
    double believed = 0, length = 0;
    for (const LinearDrive& drive : drives) {
        const double number = drive.nuisances.squaredNorm();
        believed += number / (1 + std::pow(kError * kEffect, 2) * drive.effects.squaredNorm()), length += number;
    }
    car.structure_error = kError;
    const Remains doubted = whatRemains(car, model, {model.fit.at, model.fit.rows});
    EXPECT_NEAR(doubted.strain, strain * believed / length, 1e-9);
    EXPECT_LT(doubted.strain, strain / 10);
}

// No more and no less likely than before the drives.
TEST(WhatRemains, OfLessThanUsualSizeSaysNothingAboutAnUnknownCause) {
    const Remains found = remainsOf(drawn(0.2, 0.2));
    EXPECT_NEAR(found.beyond_ordinary, 0, 0.5);
    EXPECT_NEAR(found.probability(), 0.1, 0.01);
}

TEST(WhatRemains, IsCertainWhereItsEvidenceIsBeyondAllNumbers) {
    EXPECT_EQ((Remains{.beyond_ordinary = 1e4, .by_chance = 0, .law = {}}.probability()), 1);
    EXPECT_EQ((Remains{.beyond_ordinary = -1e4, .by_chance = 0, .law = {}}.probability()), 0.1);
}

// A remainder that hides in the noise needs no cause, however surely it is there.
TEST(WhatRemains, IsNotSeenWhereChanceLeavesAsLargeAGap) {
    EXPECT_TRUE(seen({.beyond_ordinary = 30, .by_chance = 0.019, .law = {}}));
    EXPECT_FALSE(seen({.beyond_ordinary = 30, .by_chance = 0.021, .law = {}}));
    EXPECT_NEAR((Remains{.beyond_ordinary = 30, .by_chance = 0.021, .law = {}}.probability()), 0.1, 1e-12);
}

TEST(WhatRemains, IsSeenWhereItsLawClosesMoreOfTheGapThanChance) {
    EXPECT_TRUE(seen({.by_chance = 1, .of_law = 4.5, .law_visible = true, .law = {}}));
    EXPECT_FALSE(seen({.by_chance = 1, .of_law = 30, .law_visible = false, .law = {}}));
    EXPECT_FALSE(seen({.beyond_ordinary = -1, .by_chance = 1, .of_law = 4.5, .law_visible = true, .law = {}}));
    EXPECT_FALSE(seen({.beyond_ordinary = 30, .by_chance = 1, .of_law = 1, .law_visible = true, .law = {}}))
        << "only the law is visible";
    EXPECT_FALSE(seen({.by_chance = 1, .of_law = 1, .law_visible = true, .rejected = 30, .law = {}}));
}

// The large remainder and the law that it follows together are what an unknown cause gains.
TEST(WhatRemains, IsSeenSoonerWhereItFollowsALaw) {
    EXPECT_FALSE(seen({.beyond_ordinary = 4, .by_chance = 0, .of_law = 0.3, .law = {}}));
    EXPECT_TRUE(seen({.beyond_ordinary = 4, .by_chance = 0, .of_law = 0.5, .law = {}}));
    EXPECT_NEAR((Remains{.beyond_ordinary = 4, .by_chance = 0, .of_law = 2, .law = {}}.probability()),
                1 / (1 + 9 * std::exp(-6)), 1e-12);
}

// A set of effects that cannot be the answer may have gained by the same remainder, so that only the larger one counts.
TEST(WhatRemains, MayLookLikeASetThatCannotBeTheAnswer) {
    EXPECT_TRUE(seen({.by_chance = 0, .rejected = 4.5, .law = {}}));
    EXPECT_FALSE(seen({.beyond_ordinary = 4, .by_chance = 0, .rejected = 4.3, .law = {}}));
    EXPECT_FALSE(seen({.by_chance = 0.021, .rejected = 30, .law = {}}));
    EXPECT_NEAR((Remains{.beyond_ordinary = 2, .by_chance = 0, .of_law = 1, .rejected = 5, .law = {}}.probability()),
                1 / (1 + 9 * std::exp(-5)), 1e-12);
}

// It is faster than the rows, whose gap says nothing of it.
TEST(WhatRemains, MayBeAVibration) {
    EXPECT_TRUE(seen({.by_chance = 1, .law = {}, .vibration = {.frequency = 5, .gain = 4.5}}));
    EXPECT_FALSE(seen({.by_chance = 1, .law = {}, .vibration = {.frequency = 5, .gain = 4.3}}));
    EXPECT_NEAR((Remains{.beyond_ordinary = 2, .by_chance = 0, .law = {}, .vibration = {.gain = 5}}.probability()),
                1 / (1 + 9 * std::exp(-5)), 1e-12);
}

// Student's t with four degrees of freedom and variance 1, against the normal distribution; lgamma(2.5) - lgamma(2) and
// the scale differ for both by a constant, which is left out.
TEST(WhatRemains, IsSeenWhereOneNumberMovedFarBeyondItsTolerance) {
    for (const auto& [moved, nats] : {std::pair{3.0, 0.23813}, {4.5, 4.10192}, {5.0, 5.99328}, {6.0, 10.63890}}) {
        const std::vector<LinearDrive> drives = drawn(1, 1);
        const Problem problem = linear_drives::problemOf(drives);
        Calibration car = linear_drives::calibrationOf(problem, drives);
        car.structure_error = 0;
        Candidate model{.effects = {0}, .fit = linear_drives::resizedFitOf(car, {0}), .fitted = true};
        model.fit.at(model.fit.free[0]) = moved;
        const Remains found = whatRemains(car, model, {model.fit.at, model.fit.rows});
        EXPECT_NEAR(found.strain, nats, 1e-4) << moved;
        EXPECT_EQ(seen(found), moved > 4.6) << moved;
    }
}

}  // namespace
}  // namespace tread::diagnose_what_remains_test
