// Probabilities of causes, against Bayes' rule by hand.
#include "diagnose/select/posterior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "diagnose/model/problem.h"
#include "diagnose/select/calibration.h"
#include "diagnose/select/search.h"
#include "diagnose/settings.h"

namespace tread {
namespace {

using diagnose::kSettings;
using diagnose::kTestable;
using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Posterior;
using diagnose::select::posterior;
using diagnose::select::Search;

constexpr double kNoMore = -1000;

// A question about ten effects without a drive: nothing is left over, and a unit of evidence counts in full.
Problem askedOf(int effects) {
    Problem problem;
    for (int e = 0; e < effects; ++e)
        problem.effects.push_back({.name = "e" + std::to_string(e), .question = {}, .source = {}, .knobs = {}});
    return problem;
}
struct TenEffects {
    Problem problem = askedOf(10);
    Calibration car{problem, {}, {}, {}, {}, {}, {}};
};

Candidate judged(std::vector<std::size_t> effects, double log_evidence) {
    return {.effects = std::move(effects), .log_evidence = log_evidence, .fit = {}, .fitted = false};
}

TEST(Posterior, OfOneEffectIsItsShareOfPriorTimesEvidence) {
    const TenEffects ten;
    const Search found{{judged({3}, 5), judged({7}, 2), judged({}, 0)}};
    const double none = 0.25, first = 0.045 * std::exp(5), second = 0.045 * std::exp(2);
    const Posterior result = posterior(ten.car, found, kNoMore);
    EXPECT_NEAR(result.of(3), first / (none + first + second), 1e-12);
    EXPECT_NEAR(result.of(7), second / (none + first + second), 1e-12);
    EXPECT_EQ(result.of(4), 0);
    EXPECT_LT(result.ofUnknown(), 1e-12);
    EXPECT_EQ(result.hypotheses.front().candidate, &found.candidates.front());
}

TEST(Posterior, OfAPairCountsForBothAndIsSplitOverAllPairs) {
    const TenEffects ten;
    const Search found{{judged({3, 7}, 12), judged({3}, 5), judged({}, 0)}};
    const double doubted = kSettings.further_share * 12;
    const double none = 0.25, one = 0.045 * std::exp(5), two = 0.15 / 45 * std::exp(12 - doubted);
    const Posterior result = posterior(ten.car, found, kNoMore);
    EXPECT_NEAR(result.of(7), two / (none + one + two), 1e-12);
    EXPECT_NEAR(result.of(3), (one + two) / (none + one + two), 1e-12);
}

TEST(Posterior, OfUnknownGrowsWithWhatLargerDisturbancesGain) {
    const TenEffects ten;
    const Search found{{judged({3}, 5), judged({}, 0)}};
    const double gain = 8;
    const double none = 0.25, one = 0.045 * std::exp(5), unknown = 0.1 * std::exp(5 + gain - kSettings.clear);
    const Posterior result = posterior(ten.car, found, gain);
    EXPECT_NEAR(result.ofUnknown(), unknown / (none + one + unknown), 1e-12);
}

TEST(Posterior, OfNothingThatShowsCountsWhatHasNotGainedEnough) {
    const TenEffects ten;
    const Search found{{judged({3}, kSettings.effect + 0.1), judged({7}, kSettings.effect - 0.1), judged({}, 0)}};
    const Posterior result = posterior(ten.car, found, 4);
    EXPECT_TRUE(result.shows(found.candidates[0].log_evidence));
    EXPECT_FALSE(result.shows(found.candidates[1].log_evidence));
    EXPECT_GT(result.ofUnknown(), 0.01);
    EXPECT_NEAR(result.ofNothingThatShows(), 1 - result.of(3) - result.ofUnknown(), 1e-12);
}

TEST(Thresholds, WhatIsTestableAndDoesNotShowIsSmallerThanTypical) {
    // Standard deviations between what is expected to gain so many nats, and what gains no more than `effect`.
    for (const double expected : {kTestable, 10 * kTestable, 1000 * kTestable}) {
        const double freedom = 0.5 * std::log(1 + 2 * expected);
        EXPECT_GT(std::sqrt(2 * expected) - std::sqrt(2 * (kSettings.effect + freedom)), 2.5) << expected;
    }
}

TEST(Thresholds, WhatIsTestableIsFoundNineteenTimesInTwenty) {
    // A gain that is measured with a standard deviation of one: its square over two, less what its freedom costs.
    const double size = std::sqrt(2 * kTestable), freedom = 0.5 * std::log(1 + 2 * kTestable);
    Random random(1);
    constexpr int kMany = 100000;
    int found = 0;
    for (int i = 0; i < kMany; ++i) {
        const double seen = (0.6 + random.uniform()) * size + random.normal();
        found += 0.5 * seen * seen - freedom > kSettings.effect ? 1 : 0;
    }
    EXPECT_GT(found, 0.95 * kMany);
    EXPECT_LT(found, 0.97 * kMany);
}

}  // namespace
}  // namespace tread
