// What a model predicts of a drive that is left out, against the density of its rows given those of the other drives,
// from the full covariance of all rows; the nuisances of the drive left out are others than theirs. The gap of that
// drive, against least squares of the other drives.
#include "diagnose/select/prediction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math/random.h"
#include "diagnose/select/doubt.h"
#include "diagnose/select/left_out.h"
#include "shared/linear_drives.h"

namespace tread::diagnose_prediction_test {
namespace {

using diagnose::model::Disturbed;
using diagnose::model::Problem;
using diagnose::model::Sizes;
using diagnose::select::Calibration;
using diagnose::select::Fit;
using diagnose::select::predicted;
using diagnose::select::Prediction;
using diagnose::select::predictiveDensities;
using diagnose::select::residualsLeftOut;
using linear_drives::fitOf;
using linear_drives::LinearDrive;
using linear_drives::logDensity;
using linear_drives::normals;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Drives of a car with the first of two effects, of these values; columns of drive d are `seen[d]` times as large.
struct Driven {
    std::vector<LinearDrive> drives;
    Problem problem;
    Calibration car;

    Driven(const std::vector<double>& values, const std::vector<double>& seen, std::uint64_t seed = 1)
        : drives(drawn(values, seen, seed)),
          problem(linear_drives::problemOf(drives)),
          car(linear_drives::calibrationOf(problem, drives)) {}

    static std::vector<LinearDrive> drawn(const std::vector<double>& values, const std::vector<double>& seen,
                                          std::uint64_t seed) {
        Random random(seed);
        std::vector<LinearDrive> all;
        for (std::size_t d = 0; d < values.size(); ++d) {
            const auto rows = static_cast<Index>(20 + d);
            LinearDrive drive{normals(rows, 1, random),
                              seen[d] * normals(rows, 2, random),
                              {},
                              normals(rows, 3, random),
                              {Disturbed::yaw, Disturbed::yaw, Disturbed::roll_error}};
            drive.measured = normals(rows, 1, random) + values[d] * drive.effects.col(0) + 0.5 * drive.nuisances +
                             drive.disturbances * normals(3, 1, random);
            all.push_back(std::move(drive));
        }
        return all;
    }
    // The drives, one of which has nuisances of its own.
    std::vector<LinearDrive> apart(std::size_t d) const {
        std::vector<LinearDrive> with = drives;
        for (std::size_t i = 0; i < with.size(); ++i) {
            const MatrixXd shared = drives[i].nuisances, none = MatrixXd::Zero(shared.rows(), shared.cols());
            with[i].nuisances.resize(shared.rows(), 2 * shared.cols());
            if (i == d) with[i].nuisances << none, shared;
            else with[i].nuisances << shared, none;
        }
        return with;
    }
    // Of each drive, given the others.
    std::vector<double> densities(const std::vector<std::size_t>& effects, const Sizes& sizes) const {
        std::vector<double> all;
        for (std::size_t d = 0; d < drives.size(); ++d) {
            const std::vector<LinearDrive> with = apart(d);
            std::vector<LinearDrive> others = with;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(d));
            all.push_back(logDensity(with, effects, sizes) - logDensity(others, effects, sizes));
        }
        return all;
    }
    // Of all drives but one, given that one.
    double densityOfOthers(std::size_t d, const std::vector<std::size_t>& effects, const Sizes& sizes) const {
        const std::vector<LinearDrive> with = apart(d);
        return logDensity(with, effects, sizes) - logDensity({with[d]}, effects, sizes);
    }
};

constexpr Sizes kSome{1, 1, 1.7, 1, 1, 1, 1, 1, 0.6}, kOther{1, 1, 2.4, 1, 1, 1, 1, 1, 1.9};

TEST(Prediction, DensityOfADriveIsThatWithTheEffectsOfAllOthers) {
    const Driven driven({1.2, 0.9, 1.1}, {1, 1, 1});
    for (const std::vector<std::size_t>& effects : {std::vector<std::size_t>{}, {0}, {1}, {0, 1}}) {
        const std::vector<double> found = predictiveDensities(driven.car, fitOf(driven.car, effects, kSome)),
                                  expected = driven.densities(effects, kSome);
        ASSERT_EQ(found.size(), 3u);
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(found[d], expected[d], 1e-9) << "drive " << d;
    }
}

// Each model with the sizes of its own remainder.
TEST(Prediction, GainIsTheSumOverTheDrivesAndItsDeviationThatOfTheirDifferences) {
    const Driven driven({1.2, 0.9, 1.1}, {1, 1, 1});
    const Prediction found = predicted(driven.car, fitOf(driven.car, {0}, kSome), fitOf(driven.car, {}, kOther));
    const std::vector<double> with = driven.densities({0}, kSome), without = driven.densities({}, kOther);
    double sum = 0, squares = 0;
    for (std::size_t d = 0; d < 3; ++d) sum += with[d] - without[d];
    for (std::size_t d = 0; d < 3; ++d) squares += std::pow(with[d] - without[d] - sum / 3, 2);
    EXPECT_NEAR(found.gain, sum, 1e-9);
    EXPECT_NEAR(found.sd, std::sqrt(3 * squares / 2), 1e-9);
    EXPECT_TRUE(found.tested);
}

TEST(Prediction, OfAnEffectThatIsTheSameInAllDrivesSucceeds) {
    const Driven driven({3, 3, 3}, {1, 1, 1});
    const Prediction found = predicted(driven.car, fitOf(driven.car, {0}), fitOf(driven.car, {}));
    EXPECT_GT(found.gain, 5);
    EXPECT_FALSE(found.fails());
}

TEST(Prediction, OfAnEffectWithOppositeValuesFails) {
    const Driven driven({3, -3}, {1, 1});
    const Prediction found = predicted(driven.car, fitOf(driven.car, {0}), fitOf(driven.car, {}));
    EXPECT_LT(found.gain, 0);
    EXPECT_TRUE(found.fails());
}

// The second drive shows most.
TEST(Prediction, OfTheOthersFromTheDriveThatTellsMost) {
    const Driven driven({1.2, 0.9, 1.1}, {1, 3, 0.5});
    const Prediction found = predicted(driven.car, fitOf(driven.car, {0}, kSome), fitOf(driven.car, {}, kOther));
    EXPECT_NEAR(found.others, driven.densityOfOthers(1, {0}, kSome) - driven.densityOfOthers(1, {}, kOther), 1e-9);
    EXPECT_FALSE(found.contradicts());
}

TEST(Prediction, ContradictsWhereTheOthersSpeakAgainstTheDriveThatTellsMost) {
    const Driven driven({3, 0, 0}, {6, 1, 1});
    const Prediction found = predicted(driven.car, fitOf(driven.car, {0}), fitOf(driven.car, {}));
    EXPECT_FALSE(found.tested) << "the first drive tells nearly all";
    EXPECT_LT(found.others, -4);
    EXPECT_TRUE(found.contradicts());
}

// If the effect is there, the others contradict with a probability of at most 0.02, whatever they show.
TEST(Prediction, SeldomContradictsATrueEffect) {
    for (const double seen : {0.2, 1.0, 3.0}) {
        int contradicted = 0;
        constexpr int kCars = 400;
        for (std::uint64_t seed = 1; seed <= kCars; ++seed) {
            const Driven driven({1, 1, 1}, {1, seen, seen}, seed);
            const Fit with = fitOf(driven.car, {0}), without = fitOf(driven.car, {});
            if (predicted(driven.car, with, without).contradicts()) ++contradicted;
        }
        EXPECT_LE(contradicted, 0.02 * kCars) << seen;
    }
}

TEST(Prediction, IsNotTestedWhereOneDriveTellsTheValue) {
    for (const double seen : {1.0, 0.5, 0.02}) {
        const Driven driven({1, 1}, {1, seen});
        const Fit with = fitOf(driven.car, {0});
        // Information about the effect in a drive, disturbances marginalised.
        const auto information = [&](std::size_t d) {
            const LinearDrive& drive = driven.drives[d];
            const Index rows = drive.measured.size();
            const MatrixXd covariance =
                MatrixXd::Identity(rows, rows) + drive.disturbances * drive.disturbances.transpose();
            return drive.effects.col(0).dot(covariance.inverse() * drive.effects.col(0));
        };
        const double first = information(0), second = information(1);
        const Prediction found = predicted(driven.car, with, fitOf(driven.car, {}));
        EXPECT_EQ(found.tested, std::max(first, second) < 0.9 * (first + second)) << seen;
        EXPECT_EQ(found.tested, seen > 0.1) << seen;
    }
    const Driven single({1}, {1});
    const Prediction found = predicted(single.car, fitOf(single.car, {0}), fitOf(single.car, {}));
    EXPECT_FALSE(found.tested);
    EXPECT_FALSE(found.fails());
    EXPECT_EQ(found.sd, 0);
}

// Rows of a drive that are left at the point of least squares of the others; the third column is an error of the model.
VectorXd leftAtTheOthers(const Driven& driven, std::size_t left_out, bool with_effect) {
    const Index free = with_effect ? 2 : 1;
    const auto columns = [&](const LinearDrive& drive) {
        MatrixXd all(drive.measured.size(), free);
        all.col(0) = drive.nuisances;
        if (with_effect) all.col(1) = drive.effects.col(0);
        return all;
    };
    MatrixXd information = MatrixXd::Identity(free, free);
    VectorXd gradient = VectorXd::Zero(free);
    for (std::size_t d = 0; d < driven.drives.size(); ++d) {
        if (d == left_out) continue;
        const LinearDrive& drive = driven.drives[d];
        const Index rows = drive.measured.size();
        const MatrixXd weights =
            (MatrixXd::Identity(rows, rows) + drive.disturbances * drive.disturbances.transpose()).inverse();
        information += columns(drive).transpose() * weights * columns(drive);
        gradient += columns(drive).transpose() * weights * drive.measured;
    }
    const LinearDrive& drive = driven.drives[left_out];
    return drive.measured - columns(drive) * information.inverse() * gradient;
}

std::vector<VectorXd> leftOutOf(const Driven& driven, const std::vector<std::size_t>& effects) {
    return residualsLeftOut(driven.car.drives(), driven.car.uncertainty, driven.problem.replays.parameters,
                            fitOf(driven.car, effects), 1);
}

TEST(LeftOut, ResidualOfADriveIsThatAtTheValuesOfTheOthers) {
    const Driven driven({1.2, 0.9, 1.1}, {1, 3, 0.5});
    for (const bool with_effect : {false, true}) {
        const std::vector<VectorXd> found =
            leftOutOf(driven, with_effect ? std::vector<std::size_t>{0} : std::vector<std::size_t>{});
        ASSERT_EQ(found.size(), 3u);
        for (std::size_t d = 0; d < 3; ++d)
            EXPECT_LT((found[d] - leftAtTheOthers(driven, d, with_effect)).norm(), 1e-9) << "drive " << d;
    }
}

TEST(LeftOut, EffectThatIsTheSameInAllDrivesShrinksTheResidualAndOneThatIsNotEnlargesIt) {
    const auto total = [](const Driven& driven, const std::vector<std::size_t>& effects) {
        const std::vector<VectorXd> left = leftOutOf(driven, effects);
        return left[0].squaredNorm() + left[1].squaredNorm();
    };
    const Driven same({2, 2}, {1, 1}), opposite({2, -2}, {1, 1});
    EXPECT_LT(total(same, {0}), total(same, {}));
    EXPECT_GT(total(opposite, {0}), total(opposite, {}));
}

TEST(LeftOut, SumIsLargerFromOneStandardDeviationOn) {
    using diagnose::select::isLarger;
    // Logarithms of ratios, in units of ln 2: 3 and 1, sum 4, deviation 2.
    EXPECT_TRUE(isLarger({8, 2}, {1, 1}));
    EXPECT_FALSE(isLarger({1, 1}, {8, 2}));
    // 3 and -1: sum 2, deviation 4.
    EXPECT_FALSE(isLarger({8, 1}, {1, 2}));
}

// A drive that the others predict badly either way does not outweigh the rest.
TEST(LeftOut, EveryDriveCountsAlike) {
    using diagnose::select::isLarger;
    EXPECT_TRUE(isLarger({2, 2, 2, 2, 19000}, {1, 1, 1, 1, 35000}));
}

// What the second effect explains beyond the nuisance and the first effect, in each drive.
TEST(Doubt, ExplainedIsThePartThatOtherParametersCannotImitate) {
    const Driven driven({1.2, 0.9, 1.1}, {1, 3, 0.5});
    const Fit fit = fitOf(driven.car, {0, 1});
    std::vector<MatrixXd> weights;
    MatrixXd information = MatrixXd::Identity(2, 2);
    VectorXd mixed = VectorXd::Zero(2);
    const auto others = [](const LinearDrive& drive) {
        MatrixXd all(drive.measured.size(), 2);
        all << drive.nuisances, drive.effects.col(0);
        return all;
    };
    for (const LinearDrive& drive : driven.drives) {
        const Index rows = drive.measured.size();
        weights.emplace_back(
            (MatrixXd::Identity(rows, rows) + drive.disturbances * drive.disturbances.transpose()).inverse());
        information += others(drive).transpose() * weights.back() * others(drive);
        mixed += others(drive).transpose() * weights.back() * drive.effects.col(1);
    }
    const double value = fit.at(fit.knobs.back());
    const std::vector<double> found = diagnose::select::explainedIn(driven.car, fit, {fit.knobs.back()});
    for (std::size_t d = 0; d < 3; ++d) {
        const LinearDrive& drive = driven.drives[d];
        const VectorXd own = value * (drive.effects.col(1) - others(drive) * information.inverse() * mixed);
        EXPECT_NEAR(found[d], own.dot(weights[d] * own), 1e-9) << "drive " << d;
    }
}

}  // namespace
}  // namespace tread::diagnose_prediction_test
