// Sets of effects in the linear model about a fit, against the density of all rows from their full covariance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "diagnose/select/sets.h"
#include "shared/linear_drives.h"

namespace tread::diagnose_sets_test {
namespace {

using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::PromisingSet;
using diagnose::select::promisingSets;
using linear_drives::LinearDrive;
using linear_drives::MatrixXd;
using linear_drives::VectorXd;

using Effects = std::vector<std::size_t>;

constexpr Eigen::Index kRows = 14, kEffects = 6;
const Effects kAll{0, 1, 2, 3, 4, 5};

// Two drives with random columns, which hold these multiples of the effects, nuisances, disturbances and noise.
std::vector<LinearDrive> drivesWith(const VectorXd& effects, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const auto draw = [&](Eigen::Index rows, Eigen::Index columns) {
        return MatrixXd(MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); }));
    };
    const VectorXd nuisances = draw(2, 1);
    std::vector<LinearDrive> drives;
    for (int d = 0; d < 2; ++d) {
        LinearDrive& drive =
            drives.emplace_back(LinearDrive{draw(kRows, 2), draw(kRows, kEffects), {}, draw(kRows, 3)});
        drive.measured = drive.effects * effects + drive.nuisances * nuisances +
                         drive.disturbances * draw(drive.disturbances.cols(), 1) + draw(kRows, 1);
    }
    return drives;
}

struct Sets {
    std::vector<LinearDrive> drives;
    Problem problem;
    Calibration car;

    explicit Sets(std::vector<LinearDrive> told)
        : drives(std::move(told)),
          problem(linear_drives::problemOf(drives)),
          car(linear_drives::calibrationOf(problem, drives)) {}

    std::vector<PromisingSet> about(const Effects& effects, const Effects& some = kAll) const {
        return promisingSets(car, car.about, linear_drives::candidateOf(car, effects), some);
    }
    // Evidence, and the prior of one of 6 sets of one effect, 15 of two and 20 of three (D28).
    double closedForm(const Effects& effects) const {
        constexpr double kPrior[] = {27.0 / 52 / 6, 9.0 / 52 / 15, 3.0 / 52 / 20};
        return linear_drives::logDensity(drives, effects, car.uncertainty.sizes) + std::log(kPrior[effects.size() - 1]);
    }
};

// Also for a candidate whose effects the sets lack.
TEST(PromisingSets, OfALinearCarHaveTheEvidenceAndThePriorOfTheClosedForm) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Sets sets(drivesWith(VectorXd{{1.5, 0, 0, -1, 0.3, 0}}, seed));
        for (const Effects& about : {Effects{1}, Effects{4, 0}, Effects{2, 3, 5}}) {
            const std::vector<PromisingSet> promising = sets.about(about);
            ASSERT_EQ(promising.size(), 40u) << "all but one of 6 + 15 + 20";
            for (const PromisingSet& one : promising)
                EXPECT_NEAR(one.promised, sets.closedForm(one.effects) - sets.closedForm(about), 1e-6);
            EXPECT_TRUE(std::is_sorted(promising.begin(), promising.end(),
                                       [](const auto& a, const auto& b) { return a.promised > b.promised; }));
        }
    }
}

// Effects 0 and 1 nearly cancel each other, and effect 2 does about the same as both: neither of the two is worth
// adding to it, nor better alone.
TEST(PromisingSets, PairIsFoundThoughNeitherOfItsEffectsHelpsAlone) {
    std::vector<LinearDrive> drives = drivesWith(VectorXd::Zero(kEffects), 4);
    for (LinearDrive& drive : drives) {
        const VectorXd difference = drive.effects.col(1);
        drive.effects.col(0) *= 4;
        drive.effects.col(1) = drive.effects.col(0) + difference;
        drive.effects.col(2) += 2 * difference;
        drive.measured += 5 * (drive.effects.col(0) - drive.effects.col(1));
    }
    const Sets sets(std::move(drives));
    for (const Effects& lesser : {Effects{0, 2}, Effects{1, 2}, Effects{0}, Effects{1}})
        ASSERT_LT(sets.closedForm(lesser), sets.closedForm({2}) + 1);
    const std::vector<PromisingSet> promising = sets.about({2});
    const auto first = std::find_if(promising.begin(), promising.end(),
                                    [](const PromisingSet& one) { return one.effects.size() < 3; });
    EXPECT_EQ(first->effects, (Effects{0, 1}));
    EXPECT_GT(first->promised, 5);
}

TEST(PromisingSets, HoldOnlyEffectsThatAreSought) {
    const Sets sets(drivesWith(VectorXd{{1.5, 0, 0, -1, 0.3, 0}}, 1));
    const std::vector<PromisingSet> promising = sets.about({1}, {0, 2});
    ASSERT_EQ(promising.size(), 3u);
    for (const PromisingSet& one : promising) {
        for (const std::size_t effect : one.effects) EXPECT_TRUE(effect == 0 || effect == 2);
    }
}

}  // namespace
}  // namespace tread::diagnose_sets_test
