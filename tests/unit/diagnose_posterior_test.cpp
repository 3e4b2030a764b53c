// Probabilities of causes, against Bayes' rule by hand.
#include "base/random.h"
#include "diagnose/posterior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/thresholds.h"

namespace tread {
namespace {

constexpr double kT = kThresholds.temperature;
constexpr double kNoMore = -1000;

struct TenEffects : Study {
    TenEffects() {
        for (int e = 0; e < 10; ++e)
            effects.push_back({.name = "e" + std::to_string(e), .question = {}, .source = {}, .knobs = {}});
    }
};

Candidate judged(std::vector<std::size_t> effects, double log_evidence) {
    return {.effects = std::move(effects), .log_evidence = log_evidence, .fit = {}, .fitted = false};
}

TEST(Posterior, OfOneEffectIsItsShareOfPriorTimesEvidence) {
    const TenEffects study;
    const Search found{{judged({3}, 5), judged({7}, 2), judged({}, 0)}};
    const double none = 0.25, first = 0.045 * std::exp(5 / kT), second = 0.045 * std::exp(2 / kT);
    const Posterior result = posterior(study, found, kNoMore);
    EXPECT_NEAR(result.of(3), first / (none + first + second), 1e-12);
    EXPECT_NEAR(result.of(7), second / (none + first + second), 1e-12);
    EXPECT_EQ(result.of(4), 0);
    EXPECT_LT(result.ofUnknown(), 1e-12);
    EXPECT_EQ(result.hypotheses.front().candidate, &found.candidates.front());
}

TEST(Posterior, OfAPairCountsForBothAndIsSplitOverAllPairs) {
    const TenEffects study;
    const Search found{{judged({3, 7}, 12), judged({3}, 5), judged({}, 0)}};
    const double doubted = kThresholds.further_share * 12;
    const double none = 0.25, one = 0.045 * std::exp(5 / kT), two = 0.15 / 45 * std::exp((12 - doubted) / kT);
    const Posterior result = posterior(study, found, kNoMore);
    EXPECT_NEAR(result.of(7), two / (none + one + two), 1e-12);
    EXPECT_NEAR(result.of(3), (one + two) / (none + one + two), 1e-12);
}

TEST(Posterior, OfUnknownGrowsWithWhatLargerDisturbancesGain) {
    const TenEffects study;
    const Search found{{judged({3}, 5), judged({}, 0)}};
    const double gain = 8;
    const double none = 0.25, one = 0.045 * std::exp(5 / kT),
                 unknown = 0.1 * std::exp((5 + gain - kThresholds.unknown) / kT);
    const Posterior result = posterior(study, found, gain);
    EXPECT_NEAR(result.ofUnknown(), unknown / (none + one + unknown), 1e-12);
}

TEST(Posterior, EffectsThatDrivesCannotShowAreNothingThatShows) {
    const TenEffects study;
    Screen screen;
    screen.detectability.assign(10, kThresholds.testable - 1);
    screen.detectability[7] = kThresholds.testable;
    const Search found{{judged({3}, 1), judged({7}, 1), judged({}, 0)}};
    const Posterior result = posterior(study, found, kNoMore);
    EXPECT_NEAR(result.ofNothingThatShows(screen), 1 - result.of(7), 1e-12);
    // One that is larger than that and does show is not nothing.
    const Search shown{{judged({3}, kThresholds.effect + 1), judged({}, 0)}};
    const Posterior with_it = posterior(study, shown, kNoMore);
    EXPECT_NEAR(with_it.ofNothingThatShows(screen), 1 - with_it.of(3), 1e-12);
}

TEST(Thresholds, WhatIsTestableIsFoundNineteenTimesInTwenty) {
    // A gain that is measured with a standard deviation of one: its square over two, less what its freedom costs.
    const double size = std::sqrt(2 * kThresholds.testable), freedom = 0.5 * std::log(1 + 2 * kThresholds.testable);
    Random random(1);
    constexpr int kMany = 100000;
    int found = 0;
    for (int i = 0; i < kMany; ++i) {
        const double seen = (0.6 + random.uniform()) * size + random.normal();
        found += 0.5 * seen * seen - freedom > kThresholds.effect ? 1 : 0;
    }
    EXPECT_GT(found, 0.95 * kMany);
    EXPECT_LT(found, 0.97 * kMany);
}

}  // namespace
}  // namespace tread
