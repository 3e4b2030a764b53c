// How often drives held out speak against a model that is true.
#include "diagnose/select/held_out.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math/random.h"
#include "diagnose/settings.h"

namespace tread::diagnose_held_out_test {
namespace {

using diagnose::select::HeldOutGap;
using diagnose::select::speaksAgainst;

// Share of trials in which the drives speak against the truth, if it differs from the model without effects by so much
// in squares. The noise of the rows has this variance, and the size of the effect this relative error.
double wronglyStruck(double difference, double variance, double error = 0) {
    constexpr int kTrials = 20000, kRows = 10;
    const double shift = std::sqrt(difference / kRows);  // of each row
    Random random(7);
    int struck = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        HeldOutGap gap{.with = 0,
                       .without = 0,
                       .difference = difference,
                       .variance = variance,
                       .by_numbers = std::pow(error * difference, 2)};
        const double wrong = error * random.normal() * shift;
        for (int row = 0; row < kRows; ++row) {
            const double noise = std::sqrt(variance) * random.normal() + wrong;
            gap.with += noise * noise, gap.without += (noise + shift) * (noise + shift);
        }
        struck += speaksAgainst(gap) ? 1 : 0;
    }
    return static_cast<double>(struck) / kTrials;
}

TEST(HeldOut, DrivesSpeakAgainstTheTruthAtMostAsOftenAsAFalseAlarm) {
    constexpr double kThreeDeviations = 0.003;  // of a share of 0.02 in so many trials
    for (const double variance : {1.0, 9.0}) {
        double most = 0;
        for (double difference = 1; difference < 60; difference += 1)
            most = std::max(most, wronglyStruck(difference * variance, variance));
        EXPECT_LT(most, diagnose::kSettings.false_alarm + kThreeDeviations);
        EXPECT_GT(most, 0.5 * diagnose::kSettings.false_alarm) << "drives that hardly show the effect may speak, too";
    }
}

TEST(HeldOut, DrivesDoNotSpeakAgainstTheTruthBecauseItsSizeIsUncertain) {
    constexpr double kError = 0.4, kThreeDeviations = 0.003;
    for (const double difference : {30.0, 100.0, 1000.0})
        EXPECT_LT(wronglyStruck(difference, 1, kError), diagnose::kSettings.false_alarm + kThreeDeviations)
            << difference;
}

TEST(HeldOut, GapThatShrinksSpeaksForAModel) {
    EXPECT_FALSE(speaksAgainst({.with = 99, .without = 100, .difference = 1000, .variance = 1}));
    EXPECT_TRUE(speaksAgainst({.with = 101, .without = 100, .difference = 1000, .variance = 1}));
}

}  // namespace
}  // namespace tread::diagnose_held_out_test
