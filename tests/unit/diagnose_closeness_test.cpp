// What an effect closes of the gap, beside what may be chance.
#include "diagnose/select/closeness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "diagnose/model/gap.h"
#include "shared/linear_drives.h"

namespace tread::diagnose_closeness_test {
namespace {

using diagnose::select::Calibration;
using diagnose::select::closesByChance;
using diagnose::select::Closest;
using diagnose::select::forcesCloseByChance;
using linear_drives::MatrixXd;
using linear_drives::VectorXd;

constexpr Eigen::Index kRows = 400;  // of 0.05 s: 20 s, of which 20 values count

// Closest cars that leave so many times the noise, with the effects and without one of them; twice without all.
bool byChance(double with, double without, double structure_error = 0) {
    const std::vector<linear_drives::LinearDrive> drives{
        {MatrixXd(kRows, 0), MatrixXd(kRows, 0), VectorXd::Zero(kRows), MatrixXd(kRows, 0), {}}};
    const diagnose::model::Problem problem = linear_drives::problemOf(drives);
    Calibration car = linear_drives::calibrationOf(problem, drives);
    car.structure_error = structure_error;
    const auto leaves = [&](double times) {
        return Closest{problem.replays.origin(), {VectorXd::Constant(kRows, times)}};
    };
    car.closest = leaves(2);
    return closesByChance(car, {leaves(with), {leaves(with * 10), leaves(without)}});
}

TEST(Closeness, OfAnEffectMustExceedWhatChanceClosesOfTheRest) {
    // Twice the noise leaves 1200 beyond noise: 60 for each of 20 values, of which chance closes ten.
    const double least = std::sqrt(4 + 600.0 / kRows);
    EXPECT_TRUE(byChance(2, 0.999 * least));
    EXPECT_FALSE(byChance(2, 1.001 * least));
    EXPECT_TRUE(byChance(2, 1.9)) << "it makes the gap larger";
}

TEST(Closeness, OfAnyEffectCountsWhereNothingIsLeft) {
    EXPECT_FALSE(byChance(0.9, 1.01));
    EXPECT_FALSE(byChance(0.9, 0.89)) << "the evidence decides";
}

TEST(Closeness, OfAnEffectMustExceedTheErrorsOfTheSignaturesOfTheOthers) {
    // The car without effects leaves 4 times the rows, the set 0.81 times. A tenth of what the other effects explain is
    // wrong, a hundredth of its square, of which chance closes ten.
    const double least = std::sqrt((0.81 + 10 * 0.01 * 4) / (1 + 10 * 0.01));
    EXPECT_TRUE(byChance(0.9, 0.999 * least, 0.1));
    EXPECT_FALSE(byChance(0.9, 1.001 * least, 0.1));
}

// A constant force beside a car that leaves a mean of `mean` and a sine whose mean square is `rest`, in units of noise.
// A nuisance of the same effect stands at `at`.
bool constantForceByChance(double mean, double rest, double at, double nuisance_effect = 1,
                           double structure_error = 0) {
    const std::vector<linear_drives::LinearDrive> drives{{MatrixXd::Constant(kRows, 1, nuisance_effect),
                                                          MatrixXd(kRows, 0),
                                                          VectorXd::Zero(kRows),
                                                          MatrixXd(kRows, 0),
                                                          {}}};
    const diagnose::model::Problem problem = linear_drives::problemOf(drives);
    Calibration car = linear_drives::calibrationOf(problem, drives);
    car.structure_error = structure_error;
    car.of_gap = diagnose::model::weightedAsTheGap(car.uncertainty, car.drives());
    const double turn = 2 * std::numbers::pi / kRows;
    const VectorXd sine = (2 * turn * VectorXd::LinSpaced(kRows, 0.5, kRows - 0.5)).array().sin();
    const VectorXd rows = std::sqrt(2 * rest) * sine + VectorXd::Constant(kRows, mean);
    Closest here{problem.replays.origin(), {rows}};
    here.at(0) = at;
    car.closest = {problem.replays.origin(), {10 * rows}};
    return forcesCloseByChance(car, {}, here, {MatrixXd::Ones(kRows, 1)});
}

// The nuisance is at the end of its tolerance and cannot take the place of the force.
const double kAtItsEnd = -std::sqrt(3.0);

TEST(Closeness, OfAForceMustExceedWhatChanceClosesOfTheRest) {
    // 20 values share the 600 beyond noise: chance closes twice 30 for each nat, and 5 nats are wanted.
    const double least = std::sqrt(5 * 2 * 30.0 / kRows);
    EXPECT_TRUE(constantForceByChance(0.99 * least, 2.5, kAtItsEnd));
    EXPECT_FALSE(constantForceByChance(1.01 * least, 2.5, kAtItsEnd));
}

TEST(Closeness, OfAForceMustExceedNoise) {
    const double least = std::sqrt(5 * 2.0 / kRows);
    EXPECT_TRUE(constantForceByChance(0.97 * least, 0.8, kAtItsEnd));
    EXPECT_FALSE(constantForceByChance(1.03 * least, 0.8, kAtItsEnd));
}

TEST(Closeness, OfAForceIsNothingWhereATolerancePlaysItsPart) {
    EXPECT_TRUE(constantForceByChance(1, 0.8, 0));
    EXPECT_FALSE(constantForceByChance(1, 0.8, 0, 0.01)) << "this nuisance closes too little";
}

TEST(Closeness, OfAForceMustExceedTheErrorsOfTheSignatures) {
    // The gap without effects is ten times as large; a share of it may be an error in the direction of the force.
    const double mean = 0.7, rest = 0.8, explained = 99 * (mean * mean + rest);
    const double most = std::sqrt(mean * mean / (5 * 2 * explained));
    EXPECT_FALSE(constantForceByChance(mean, rest, kAtItsEnd, 1, 0.97 * most));
    EXPECT_TRUE(constantForceByChance(mean, rest, kAtItsEnd, 1, 1.03 * most));
}

}  // namespace
}  // namespace tread::diagnose_closeness_test
