// Probabilities of causes, against Bayes' rule by hand.
#include "diagnose/select/posterior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/math/random.h"
#include "diagnose/model/problem.h"
#include "diagnose/select/calibration.h"
#include "diagnose/select/search.h"
#include "diagnose/settings.h"

namespace tread::diagnose_posterior_test {
namespace {

using diagnose::kSettings;
using diagnose::kTestable;
using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Posterior;
using diagnose::select::posterior;
using diagnose::select::Search;

// (D28): one, two and three causes share what no cause leaves, each a third as likely as one cause less.
constexpr double kOne = 0.75 / (1 + 1.0 / 3 + 1.0 / 9), kTwo = kOne / 3;

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

TEST(Posterior, PriorsOfAllNumbersOfCausesSumToOne) {
    EXPECT_NEAR(kSettings.prior(0) + kSettings.prior(1) + kSettings.prior(2) + kSettings.prior(3), 1, 1e-12);
}

TEST(Posterior, OfOneEffectIsItsShareOfPriorTimesEvidence) {
    const TenEffects ten;
    const Search found{{judged({3}, 5), judged({7}, 2), judged({}, 0)}};
    const double none = 0.25, first = kOne / 10 * std::exp(5), second = kOne / 10 * std::exp(2);
    const Posterior result = posterior(ten.car, found, {true, true, true});
    EXPECT_NEAR(result.of(3), first / (none + first + second), 1e-12);
    EXPECT_NEAR(result.of(7), second / (none + first + second), 1e-12);
    EXPECT_EQ(result.of(4), 0);
    EXPECT_NEAR(result.ofNothing(), none / (none + first + second), 1e-12);
    EXPECT_EQ(result.hypotheses.front().candidate, &found.candidates.front());
}

TEST(Posterior, OfAPairCountsForBothAndIsSplitOverAllPairs) {
    const TenEffects ten;
    const Search found{{judged({3, 7}, 12), judged({3}, 5), judged({}, 0)}};
    const double none = 0.25, one = kOne / 10 * std::exp(5), two = kTwo / 45 * std::exp(12);
    const Posterior result = posterior(ten.car, found, {true, true, true});
    EXPECT_NEAR(result.of(7), two / (none + one + two), 1e-12);
    EXPECT_NEAR(result.of(3), (one + two) / (none + one + two), 1e-12);
}

// (D32b): an unknown cause has the prior 0.1, and a fifth of that for each number of effects that may imitate it.
TEST(Posterior, CountsForAnUnknownCauseWhatItMayLookLike) {
    const TenEffects ten;
    const Search found{{judged({3, 7}, 12), judged({3}, 5), judged({}, 0)}};
    const Posterior result = posterior(ten.car, found, {true, true, true});
    const double genuine_one = 0.9 * kOne / (0.9 * kOne + 0.02), genuine_two = 0.9 * kTwo / (0.9 * kTwo + 0.02);
    const double pair = result.of(7), single = result.of(3) - pair;
    EXPECT_NEAR(result.genuinelyOf(7), pair * genuine_two, 1e-12);
    EXPECT_NEAR(result.genuinelyOf(3), pair * genuine_two + single * genuine_one, 1e-12);
    EXPECT_NEAR(result.genuine(), result.genuinelyOf(3) + result.ofNothing(), 1e-12);
}

TEST(Posterior, OfWhatIsStruckOffIsSharedByTheOthers) {
    const TenEffects ten;
    const Search found{{judged({3}, 9), judged({7}, 2), judged({}, 0)}};
    const double none = 0.25, second = kOne / 10 * std::exp(2);
    const Posterior result = posterior(ten.car, found, {false, true, true});
    EXPECT_EQ(result.of(3), 0);
    EXPECT_NEAR(result.of(7), second / (none + second), 1e-12);
    EXPECT_NEAR(result.of(7) + result.ofNothing(), 1, 1e-12);
    EXPECT_EQ(result.hypotheses.size(), 2u);
}

Candidate fitted(std::vector<std::size_t> effects, double log_evidence) {
    Candidate one = judged(std::move(effects), log_evidence);
    one.fitted = true;
    return one;
}

// Sets of effects with these probabilities.
struct OfTwo {
    Candidate a = fitted({3}, 20), b = fitted({7}, 6), both = fitted({7, 3}, 22), rival = fitted({3, 8}, 21),
              weak = fitted({8}, 4), none = judged({}, 0);

    using Hypotheses = std::vector<diagnose::select::Hypothesis>;
    static Posterior of(Hypotheses hypotheses) {
        std::sort(hypotheses.begin(), hypotheses.end(),
                  [](const auto& x, const auto& y) { return x.probability > y.probability; });
        return {std::move(hypotheses)};
    }
};

TEST(Posterior, NeedsAnEffectWhereTheSetWithoutItIsTooImprobable) {
    const OfTwo sets;
    const auto& [a, b, both, rival, weak, none] = sets;
    const auto needed = [](OfTwo::Hypotheses hypotheses) { return OfTwo::of(std::move(hypotheses)).needed(); };
    EXPECT_EQ(needed({{&a, 0.97}, {&none, 0.03}}), &none);
    EXPECT_EQ(needed({{&a, 0.99}, {&none, 0.01}}), &a);
    EXPECT_EQ(needed({{&both, 0.979}, {&a, 0.02}, {&none, 0.001}}), &a);
    EXPECT_EQ(needed({{&both, 0.989}, {&a, 0.01}, {&none, 0.001}}), &both);
    EXPECT_EQ(needed({{&both, 0.6}, {&rival, 0.389}, {&a, 0.01}, {&none, 0.001}}), &both) << "rivals of the second";
    EXPECT_EQ(needed({{&weak, 0.6}, {&a, 0.399}, {&none, 0.001}}), &a) << "gains too little";
}

TEST(Posterior, IsLikelierWithOneMoreEffectWhereLargerSetsAre) {
    const OfTwo sets;
    const auto more = [&](OfTwo::Hypotheses hypotheses) {
        return OfTwo::of(std::move(hypotheses)).likelierWithOneMore(sets.a);
    };
    const auto& [a, b, both, rival, weak, none] = sets;
    EXPECT_EQ(more({{&both, 0.6}, {&a, 0.39}, {&none, 0.01}}), &both);
    EXPECT_EQ(more({{&a, 0.6}, {&both, 0.39}, {&none, 0.01}}), nullptr);
    EXPECT_EQ(more({{&a, 0.4}, {&both, 0.3}, {&rival, 0.29}, {&none, 0.01}}), &both) << "something else acts as well";
    EXPECT_EQ(more({{&a, 0.4}, {&b, 0.59}, {&none, 0.01}}), nullptr);
}

TEST(Posterior, AnotherSetMayBeTheAnswerInsteadUnlessBothActTogether) {
    const Candidate a = judged({3}, 0), b = judged({7}, 0), both = judged({3, 7}, 0), none = judged({}, 0);
    const auto alternatives = [&](double of_a, double of_b, double of_both) {
        return Posterior{.hypotheses = {{&a, of_a}, {&b, of_b}, {&both, of_both}, {&none, 1 - of_a - of_b - of_both}}}
            .alternativesTo(a);
    };
    EXPECT_EQ(alternatives(0.6, 0.3, 0.1), std::vector{&b});
    EXPECT_TRUE(alternatives(0.3, 0.2, 0.4).empty()) << "b acts beside a";
    EXPECT_TRUE(alternatives(0.6, 0.04, 0.01).empty()) << "less than a twentieth";
    EXPECT_TRUE(alternatives(0.85, 0.08, 0.01).empty()) << "a is sure among the sets of one effect";
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
}  // namespace tread::diagnose_posterior_test
