// How far a gap shrinks: levels and closure of a car of two waves, against sums of squares by hand.
#include "diagnose/explain/how_far.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/linear_car.h"

namespace tread::diagnose_how_far_test {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::explain::howFar;
using diagnose::model::Deviation;
using diagnose::model::nominalCar;
using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::Fit;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const diagnose::Progress kQuiet = [](double, const std::string&) {};

constexpr Index kRatio = 0;  // the only parameter: nothing else is uncertain
constexpr double kTruth = -0.7;

// Two drives of a car whose ratio is 0.93 of the nominal one. No push and no speed at the start does anything to it, so
// that squares are those of the weighted rows.
struct Driven {
    simple_car::Case made = [] {
        VehicleParams truth = linear_car::nominal();
        truth.steering.ratio *= 1 + 0.1 * kTruth;
        simple_car::Case all = linear_car::recorded(truth, 3);
        all.file.tolerances = {{.path = "*"}};
        return all;
    }();
    Problem problem = diagnose::model::problemOf(
        made.nominal, made.file, made.recorded, {simple_car::effect("ratio", "steering.ratio")}, linear_car::options());
    Calibration car = diagnose::select::calibrate(problem, nominalCar(problem, kQuiet), kQuiet);

    VectorXd over(std::size_t d, const VectorXd& rows) const {
        return linear_car::weighted(problem.drives[d], car.uncertainty.noise[d], rows);
    }
    // Squares that the car at so many units of the ratio leaves in a drive.
    double left(std::size_t d, double at) const {
        const recording::RecordedDrive& drive = problem.drives[d];
        const VehicleParams& nominal = made.nominal.vehicle;
        const VectorXd rows = linear_car::nominalRows(drive, nominal) +
                              0.1 * at * nominal.steering.ratio * linear_car::rowsOf(drive, linear_car::ofRatio);
        const VectorXd off = over(d, drive.measured - rows);
        const auto misread = linear_car::misread(drive, car.uncertainty.noise[d], car.about.about.rows[d]);
        MatrixXd covariance = MatrixXd::Identity(off.size(), off.size());
        for (std::size_t i = 0; i < misread.size(); ++i)
            covariance +=
                std::pow(std::min(1.0, car.uncertainty.sizes[placeOf(linear_car::kMisread[i])]), 2) * misread[i];
        return off.dot(covariance.llt().solve(off));
    }
    // Squares by which that car differs from the nominal one.
    double differs(std::size_t d, double at) const {
        const double change = 0.1 * at * made.nominal.vehicle.steering.ratio;
        return over(d, change * linear_car::rowsOf(problem.drives[d], linear_car::ofRatio)).squaredNorm();
    }
    double expected(std::size_t d) const { return 0.375 * static_cast<double>(problem.drives[d].rows()); }
    double level(double at) const { return std::sqrt((left(0, at) + left(1, at)) / (expected(0) + expected(1))); }

    // An answer that knows its ratio for certain.
    Diagnosis answered(double at, double calibrated = 0) const {
        Fit answer;
        answer.free = answer.knobs = {kRatio};
        answer.at = Deviation::Constant(1, at);
        answer.covariance = MatrixXd::Zero(1, 1);
        Diagnosis diagnosis;
        howFar(diagnosis, car, diagnose::select::heldOut(car), {Deviation::Constant(1, calibrated), answer});
        return diagnosis;
    }
};

TEST(HowFar, LevelsAreRootsOfSquaresOverThoseOfNoise) {
    const Driven driven;
    const Diagnosis d = driven.answered(-0.5, -0.2);
    const auto& levels = d.how_far.training;
    EXPECT_NEAR(levels.nominal, driven.level(0), 1e-9);
    EXPECT_NEAR(levels.calibrated, driven.level(-0.2), 1e-9);
    EXPECT_NEAR(levels.extended, driven.level(-0.5), 1e-9);
    EXPECT_EQ(levels.floor, 1);
    EXPECT_GT(levels.nominal, 1.5);
    EXPECT_NEAR(driven.level(kTruth), 1, 0.15) << "what the true car leaves is noise";
}

TEST(HowFar, AnswerThatIsTheTrueCarClosesTheWholeGap) {
    const Diagnosis d = Driven{}.answered(kTruth);
    EXPECT_EQ(d.how_far.closure, 1);
    EXPECT_EQ(d.how_far.closure_low, 1);
    EXPECT_TRUE(d.how_far.in_sample);
}

// The answer takes itself for the truth; what it leaves in the recordings beyond two standard deviations of their noise
// is not closed all the same.
TEST(HowFar, WhatAnAnswerLeavesBeyondNoiseIsNotClosed) {
    const Driven driven;
    constexpr double kAnswer = -0.4;
    double before = 0, after = 0, lowest = 1, highest = 0;
    for (std::size_t d = 0; d < 2; ++d) {
        const double floor = driven.expected(d);
        const double beyond = driven.left(d, kAnswer) - floor - 2 * std::sqrt(2 * floor);
        ASSERT_GT(beyond, 0);
        before += driven.differs(d, kAnswer), after += beyond;
        lowest = std::min(lowest, 1 - beyond / driven.differs(d, kAnswer));
        highest = std::max(highest, 1 - beyond / driven.differs(d, kAnswer));
    }
    const Diagnosis d = driven.answered(kAnswer);
    EXPECT_NEAR(d.how_far.closure, 1 - after / before, 1e-9);
    EXPECT_LT(d.how_far.closure, 0.9);
    // Drives are drawn with replacement: one of them twice in half of the samples.
    EXPECT_NEAR(d.how_far.closure_low, lowest, 1e-9);
    EXPECT_NEAR(d.how_far.closure_high, highest, 1e-9);
}

TEST(HowFar, HeldOutDrivesJudgeWhereThereAreSome) {
    Driven driven;
    driven.made.file.recordings.back().hold_out = true;
    const Problem problem =
        diagnose::model::problemOf(driven.made.nominal, driven.made.file, driven.made.recorded,
                                   {simple_car::effect("ratio", "steering.ratio")}, linear_car::options());
    const Calibration car = diagnose::select::calibrate(problem, nominalCar(problem, kQuiet), kQuiet);
    Fit answer;
    answer.free = answer.knobs = {kRatio};
    answer.at = Deviation::Constant(1, kTruth);
    answer.covariance = MatrixXd::Zero(1, 1);
    Diagnosis d;
    howFar(d, car, diagnose::select::heldOut(car), {car.fit.at, answer});
    EXPECT_FALSE(d.how_far.in_sample);
    EXPECT_GT(d.how_far.held_out.nominal, 1.5);
    EXPECT_NEAR(d.how_far.held_out.extended, 1, 0.3);
    EXPECT_EQ(d.how_far.closure, 1);
    ASSERT_EQ(d.overlays.size(), 2u);
    EXPECT_FALSE(d.overlays[0].hold_out);
    EXPECT_TRUE(d.overlays[1].hold_out);
}

}  // namespace
}  // namespace tread::diagnose_how_far_test
