// What a set of causes gains because a force of unknown cause may act beside it, against densities of the rows from
// their full covariance.
#include "diagnose/select/force_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math/random.h"
#include "shared/linear_drives.h"

namespace tread::diagnose_force_law_test {
namespace {

using diagnose::model::Disturbed;
using diagnose::model::kDisturbedKinds;
using diagnose::model::Problem;
using diagnose::model::Sizes;
using diagnose::select::Calibration;
using diagnose::select::Fit;
using diagnose::select::ForceLaws;
using diagnose::select::gainIfUnknown;
using linear_drives::LinearDrive;
using linear_drives::logDensity;
using linear_drives::normals;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kRows = 40, kHats = 6;
constexpr double kApart = 0.25;  // s

Index placeOfFirst(Disturbed kind) {
    return static_cast<Index>(placeOf(kind)) * kHats;
}

// Rows of a constant force and a constant yaw moment of one usual size: all hats of a kind have the height 1.
MatrixXd constantForces(const LinearDrive& drive) {
    MatrixXd both(kRows, 2);
    both << drive.disturbances.middleCols(placeOfFirst(Disturbed::longitudinal), kHats).rowwise().sum(),
        drive.disturbances.middleCols(placeOfFirst(Disturbed::yaw), kHats).rowwise().sum();
    return both;
}

// Two drives of a car that a constant force of so many usual sizes drags and turns.
std::vector<LinearDrive> dragged(double by) {
    Random random(5);
    std::vector<LinearDrive> all;
    for (int d = 0; d < 2; ++d) {
        LinearDrive drive{normals(kRows, 1, random),
                          normals(kRows, 1, random),
                          {},
                          0.3 * normals(kRows, kHats * std::ssize(kDisturbedKinds), random),
                          {}};
        for (const Disturbed kind : kDisturbedKinds) drive.kinds.insert(drive.kinds.end(), kHats, kind);
        drive.measured = normals(kRows, 1, random) + by * constantForces(drive) * VectorXd::Ones(2);
        all.push_back(std::move(drive));
    }
    return all;
}

struct Dragged {
    explicit Dragged(double by) : drives(dragged(by)), problem(linear_drives::problemOf(drives)) {
        // Only the constant law finds its signal, for no channel is measured.
        for (recording::RecordedDrive& drive : problem.drives)
            for (int i = 0; i < 50 * (kHats - 1); ++i) drive.time.push_back(i * kApart / 50);
    }
    Calibration car() const {
        Calibration car = linear_drives::calibrationOf(problem, drives);
        for (diagnose::model::Disturbances& one : car.uncertainty.disturbing) {
            for (const Disturbed kind : kDisturbedKinds)
                one.hats[placeOf(kind)] = {kApart, placeOfFirst(kind), MatrixXd::Identity(kHats, kHats)};
        }
        return car;
    }

    std::vector<LinearDrive> drives;
    Problem problem;
};

// The density of the rows with these effects and the constant law, whose force is of this size a priori.
double densityWithLaw(std::vector<LinearDrive> drives, const std::vector<std::size_t>& effects, double force,
                      const Sizes& sizes) {
    for (LinearDrive& drive : drives) {
        MatrixXd with(kRows, drive.nuisances.cols() + 2);
        with << drive.nuisances, force * constantForces(drive);
        drive.nuisances = with;
    }
    return logDensity(drives, effects, sizes);
}

double priorOf(const Sizes& sizes) {
    return diagnose::model::logPrior(sizes, diagnose::model::kWidePrior);
}

const double kChoices = std::log(51);  // of 17 laws, each of three sizes

// (D35) with the sizes of the fit: the evidence of a law is at least as large beside the remainder that it leaves.
double gainAtTheSizesOf(const Fit& fit, const std::vector<LinearDrive>& drives,
                        const std::vector<std::size_t>& effects) {
    double most = -kInfinity;
    for (const double force : {2.0, 8.0, 32.0})
        most = std::max(most, densityWithLaw(drives, effects, force, fit.sizes));
    return most - logDensity(drives, effects, fit.sizes) - kChoices;
}

// The search for the sizes ends when their logarithms move by less than 0.05; the density is flat at its maximum.
constexpr double kNearMaximum = 0.2;  // nats

TEST(ForceLaws, ATenthOfTheirEvidenceCountsForASet) {
    const Dragged told(4);
    const Calibration car = told.car();
    const ForceLaws laws(car);
    for (const std::vector<std::size_t>& effects : {std::vector<std::size_t>{}, {0}}) {
        const Fit fit = linear_drives::fitOf(car, effects);  // with the usual sizes, which are the true ones
        const double at_least = gainAtTheSizesOf(fit, told.drives, effects);
        const double gain = laws.best(fit).told.gain;
        ASSERT_GT(at_least, 10);
        EXPECT_GE(gain, at_least - 1e-6);
        EXPECT_NEAR(gainIfUnknown(laws.best(fit)), std::log(0.9 + 0.1 * std::exp(gain)), 1e-9);
    }
}

// The largest of a function of the sizes, one size after the other.
template <class Of>
double largestOf(Of&& of) {
    Sizes sizes;
    sizes.fill(1);
    double most = of(sizes);
    for (const double step : {1.0, 0.3, 0.1, 0.03}) {
        for (int round = 0; round < 4; ++round) {
            for (const Disturbed kind : kDisturbedKinds) {
                for (const double factor : {std::exp(step), std::exp(-step)}) {
                    Sizes other = sizes;
                    other[placeOf(kind)] *= factor;
                    const double now = of(other);
                    if (now > most) most = now, sizes = other;
                }
            }
        }
    }
    return most;
}

TEST(ForceLaws, HaveTheEvidenceOfTheRemainderThatTheyLeave) {
    const Dragged told(30);
    const Calibration car = told.car();
    const Fit fit = linear_drives::resizedFitOf(car, {});
    ASSERT_GT(fit.sizes[placeOf(Disturbed::longitudinal)], 3) << "without the law, the remainder is large";
    const double before = logDensity(told.drives, {}, fit.sizes) + priorOf(fit.sizes);
    double expected = -kInfinity;
    for (const double force : {8.0, 32.0}) {
        const double with = largestOf(
            [&](const Sizes& sizes) { return densityWithLaw(told.drives, {}, force, sizes) + priorOf(sizes); });
        expected = std::max(expected, with - before - kChoices);
    }
    EXPECT_GT(expected, gainAtTheSizesOf(fit, told.drives, {}) + 5);
    EXPECT_NEAR(ForceLaws(car).best(fit).told.gain, expected, kNearMaximum);
}

TEST(ForceLaws, ThatDoNotActCostASetLittle) {
    const Dragged told(0);
    const Calibration car = told.car();
    EXPECT_NEAR(gainIfUnknown(ForceLaws(car).best(linear_drives::fitOf(car, {}))), std::log(0.9), 0.01);
}

}  // namespace
}  // namespace tread::diagnose_force_law_test
