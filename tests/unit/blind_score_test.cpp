// Scoring of a blind check, against hand-made answers and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "blind/score.h"
#include "diagnose/answer/diagnosis.h"
#include "tread/problem.h"

namespace tread {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::Estimate;
using diagnose::answer::Overlay;
using diagnose::answer::RankedEffect;
using diagnose::answer::Verdict;

CaseKey keyOf(const std::string& name, CaseKind kind, std::vector<std::string> effects = {}) {
    CaseKey key;
    key.name = name;
    key.kind = kind;
    key.effects = std::move(effects);
    return key;
}

CaseAnswer answerOf(const std::string& name, Verdict verdict, std::vector<std::string> causes = {},
                    double probability = 0.8) {
    CaseAnswer answer;
    answer.name = name;
    answer.verdict = verdict;
    for (const std::string& cause : causes) {
        RankedEffect effect;
        effect.name = cause;
        effect.probability = probability;
        answer.effects.push_back(effect);
    }
    answer.credible_set = causes;
    answer.causes = std::move(causes);
    answer.testable = {{"drag", 50}, {"mass", 50}, {"mu", 50}, {"faint", 1}};
    return answer;
}

TEST(BlindScore, WilsonIntervalSolvesItsQuadratic) {
    // Both ends solve (p - hits / n)^2 = z^2 p (1 - p) / n.
    constexpr double kZ = 1.959963984540054;
    for (const auto& [hits, of] : std::vector<std::pair<int, int>>{{79, 82}, {1, 3}, {5, 10}}) {
        const Interval interval = wilson(hits, of);
        for (const double p : {interval.low, interval.high}) {
            const double share = static_cast<double>(hits) / of;
            EXPECT_NEAR((p - share) * (p - share), kZ * kZ * p * (1 - p) / of, 1e-12);
        }
        EXPECT_LT(interval.low, interval.high);
    }
    EXPECT_NEAR(wilson(29, 29).low, 29 / (29 + kZ * kZ), 1e-12);
    EXPECT_EQ(wilson(29, 29).high, 1);
    EXPECT_EQ(wilson(0, 0).low, 0);
    EXPECT_EQ(wilson(0, 0).high, 1);
}

TEST(BlindScore, CalibrationErrorIsTheWeightedDistanceFromTheDiagonal) {
    // Ten claims of 0.85, of which 7 are right; ten of 0.25, of which 4 are: (10 * 0.15 + 10 * 0.15) / 20.
    std::vector<Claim> claims;
    for (int i = 0; i < 10; ++i) claims.push_back({0.85, i < 7});
    for (int i = 0; i < 10; ++i) claims.push_back({0.25, i < 4});
    EXPECT_NEAR(calibrationError(reliability(claims)), 0.15, 1e-12);
    EXPECT_EQ(calibrationError(reliability({})), 0);
    const auto certain = reliability({{1.0, true}});
    EXPECT_EQ(certain.back().claims, 1);
}

TEST(BlindScore, SingleCauseIsNamedFirstAloneOrNot) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::one, {"drag"}), keyOf("b", CaseKind::one, {"drag"}),
                                    keyOf("c", CaseKind::one, {"drag"}), keyOf("d", CaseKind::one, {"drag"})};
    CaseAnswer either = answerOf("c", Verdict::ambiguous, {"mass", "drag"});
    either.causes = {"mass"};
    either.alternatives = {{"drag"}};
    const BlindScore result =
        score(keys, {answerOf("a", Verdict::explained, {"drag"}), answerOf("b", Verdict::explained, {"drag", "mass"}),
                     either, answerOf("d", Verdict::nothing)});
    EXPECT_EQ(result.figure("named_first").hits, 2);
    EXPECT_EQ(result.figure("named_first").of, 4);
    EXPECT_EQ(result.figure("named_alone").hits, 1);
    EXPECT_EQ(result.figure("among_first_two").hits, 3);
    EXPECT_EQ(result.figure("detected").hits, 3);
    EXPECT_EQ(result.figure("in_credible_set").hits, 3);
    EXPECT_EQ(result.confusion.at("drag").at("drag + mass"), 1);
    EXPECT_EQ(result.confusion.at("drag").at("drag or mass"), 1);
    EXPECT_EQ(result.mean_credible_set, 1.25);
}

TEST(BlindScore, EffectThatResemblesAnotherIsRightAsAnAlternative) {
    // Of the mass the drives show 50 nats, 49 of which the drag would imitate; of the drag more than ten times as much.
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::ambiguous;
    diagnosis.causes = {"drag"};
    diagnosis.alternatives = {{"mass"}};
    diagnosis.expected_evidence = {{"drag", 600}, {"mass", 50}};
    diagnosis.confusable = {{"drag", "mass", std::sqrt(0.98), 1, "coast_down"}};
    diagnosis.effects = {RankedEffect{.name = "drag", .parameters = {}},
                         RankedEffect{.name = "mass", .parameters = {}}};
    const CaseAnswer answer = tread::answerOf("a", diagnosis);
    EXPECT_EQ(answer.confusable, std::vector<std::string>{"mass"});
    const BlindScore mass = score({keyOf("a", CaseKind::one, {"mass"})}, {answer});
    EXPECT_EQ(mass.figure("named_first").of, 0);
    EXPECT_EQ(mass.figure("confusable_named").hits, 1);
    const BlindScore drag = score({keyOf("a", CaseKind::one, {"drag"})}, {answer});
    EXPECT_EQ(drag.figure("named_first").hits, 1);
    EXPECT_EQ(drag.figure("confusable_named").of, 0);
}

TEST(BlindScore, EffectThatNoDriveShowsCountsOnlyWhereItSaysSo) {
    CaseAnswer says_so = answerOf("a", Verdict::nothing), silent = answerOf("b", Verdict::nothing);
    says_so.credible_set = {"none"};
    const BlindScore result =
        score({keyOf("a", CaseKind::one, {"faint"}), keyOf("b", CaseKind::one, {"faint"})}, {says_so, silent});
    EXPECT_EQ(result.figure("named_first").of, 0);
    EXPECT_EQ(result.figure("named_first_any").of, 2);
    EXPECT_EQ(result.figure("detected").of, 0);
    EXPECT_EQ(result.figure("in_credible_set").hits, 1);
    EXPECT_EQ(result.figure("in_credible_set").of, 2);
}

TEST(BlindScore, FalseAlarmsArePairsUnknownsAndSinglesAlike) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::none), keyOf("b", CaseKind::none), keyOf("c", CaseKind::none),
                                    keyOf("d", CaseKind::none)};
    const BlindScore result =
        score(keys, {answerOf("a", Verdict::nothing), answerOf("b", Verdict::not_testable),
                     answerOf("c", Verdict::unknown), answerOf("d", Verdict::explained, {"drag"})});
    EXPECT_EQ(result.figure("false_alarm").hits, 2);
    EXPECT_EQ(result.figure("false_alarm").of, 4);
}

TEST(BlindScore, BaselinesAreCountedWhereTheyAreKnown) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::one, {"drag"}), keyOf("b", CaseKind::one, {"drag"}),
                                    keyOf("c", CaseKind::none), keyOf("d", CaseKind::one, {"drag"})};
    std::vector<CaseAnswer> answers{answerOf("a", Verdict::explained, {"drag"}),
                                    answerOf("b", Verdict::explained, {"drag"}), answerOf("c", Verdict::nothing),
                                    answerOf("d", Verdict::explained, {"drag"})};
    answers[0].baselines = {.largest_reduction = "drag", .bic = "drag"};
    answers[1].baselines = {.largest_reduction = "mass", .bic = "drag"};
    answers[2].baselines = {.largest_reduction = "mass", .bic = "none"};
    const BlindScore result = score(keys, answers);
    EXPECT_EQ(result.figure("named_first").hits, 3);
    EXPECT_EQ(result.figure("largest_reduction_first").hits, 1);
    EXPECT_EQ(result.figure("largest_reduction_first").of, 2);
    EXPECT_EQ(result.figure("bic_first").hits, 2);
    EXPECT_EQ(result.figure("largest_reduction_false_alarm").hits, 1);
    EXPECT_EQ(result.figure("bic_false_alarm").hits, 0);
    EXPECT_EQ(result.figure("bic_false_alarm").of, 1);
    const std::string text = scoreText(result);
    EXPECT_NE(text.find("by the largest reduction"), std::string::npos) << text;
}

TEST(BlindScore, PairIsExactInAnyOrder) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::two, {"drag", "mass"}),
                                    keyOf("b", CaseKind::two, {"drag", "mass"}),
                                    keyOf("c", CaseKind::two, {"drag", "mass"})};
    const BlindScore result =
        score(keys, {answerOf("a", Verdict::explained, {"mass", "drag"}), answerOf("b", Verdict::explained, {"mass"}),
                     answerOf("c", Verdict::explained, {"mu"})});
    EXPECT_EQ(result.figure("pair_exact").hits, 1);
    EXPECT_EQ(result.figure("pair_one_first").hits, 2);
}

TEST(BlindScore, OutsiderIsUnknownInItsPlaceOrWronglyBlamed) {
    std::vector<CaseKey> keys{keyOf("a", CaseKind::outside), keyOf("b", CaseKind::outside),
                              keyOf("c", CaseKind::outside)};
    for (CaseKey& key : keys) key.generalised_forces = {"yaw"};
    CaseAnswer right = answerOf("a", Verdict::unknown), elsewhere = answerOf("b", Verdict::unknown);
    right.generalised_force = "yaw";
    elsewhere.generalised_force = "roll";
    const BlindScore result = score(keys, {right, elsewhere, answerOf("c", Verdict::explained, {"mu"})});
    EXPECT_EQ(result.figure("unknown").hits, 2);
    EXPECT_EQ(result.figure("unknown_force").hits, 1);
    EXPECT_EQ(result.figure("unknown_force").of, 2);
    EXPECT_EQ(result.figure("wrongly_blamed").hits, 1);
}

TEST(BlindScore, WrongAndConfidentIsCountedOverEveryClaim) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::none), keyOf("b", CaseKind::none),
                                    keyOf("c", CaseKind::one, {"drag"})};
    const BlindScore result =
        score(keys, {answerOf("a", Verdict::explained, {"mu"}, 0.95), answerOf("b", Verdict::explained, {"mu"}, 0.6),
                     answerOf("c", Verdict::explained, {"drag"}, 0.99)});
    EXPECT_EQ(result.figure("wrong_confident").hits, 1);
    EXPECT_EQ(result.figure("wrong_confident").of, 3);
}

TEST(BlindScore, EveryNamedEffectClaimsItsOwnProbability) {
    const CaseKey pair = keyOf("a", CaseKind::two, {"drag", "mass"});
    CaseAnswer answer = answerOf("a", Verdict::ambiguous, {"drag", "mu"}, 0.9);
    answer.effects[1].probability = 0.6;
    answer.effects.push_back({.name = "mass", .probability = 0.4, .parameters = {}});
    answer.alternatives = {{"drag", "mass"}};
    std::map<double, bool> right;
    for (const Claim& claim : claimsOf(pair, answer)) right[claim.probability] = claim.right;
    EXPECT_EQ(right, (std::map<double, bool>{{0.9, true}, {0.6, false}, {0.4, true}}));
}

TEST(BlindScore, PairsThatCannotBeToldApartStandWhole) {
    CaseAnswer answer = answerOf("a", Verdict::ambiguous, {"mass", "drag"});
    answer.alternatives = {{"mu", "drag"}};
    EXPECT_EQ(wordsOf(answer), "drag + mass or drag + mu");
}

TEST(BlindScore, NothingIsARightClaimWhereNothingCouldShow) {
    CaseAnswer nothing = answerOf("a", Verdict::nothing), unknown = answerOf("a", Verdict::unknown);
    nothing.probability_of_nothing = 0.9;
    unknown.probability_of_unknown = 0.7;
    const auto right = [](const CaseKey& key, const CaseAnswer& answer) {
        const std::vector<Claim> claims = claimsOf(key, answer);
        return claims.size() == 1 && claims.front().right;
    };
    EXPECT_TRUE(right(keyOf("a", CaseKind::none), nothing));
    EXPECT_TRUE(right(keyOf("a", CaseKind::small, {"drag"}), nothing));
    EXPECT_TRUE(right(keyOf("a", CaseKind::one, {"faint"}), nothing));
    EXPECT_FALSE(right(keyOf("a", CaseKind::one, {"drag"}), nothing));
    EXPECT_FALSE(right(keyOf("a", CaseKind::outside), nothing));
    EXPECT_TRUE(right(keyOf("a", CaseKind::outside), unknown));
    EXPECT_FALSE(right(keyOf("a", CaseKind::none), unknown));
}

TEST(BlindScore, ParameterErrorsAreInStandardDeviations) {
    CaseKey key = keyOf("a", CaseKind::one, {"drag"});
    key.numbers["aero.drag_area"] = {.nominal = 0.6, .value = 0.8, .change = 1};
    CaseAnswer answer = answerOf("a", Verdict::explained, {"drag"});
    Estimate estimate;
    estimate.value = 0.86;
    estimate.sd = 0.02;
    answer.effects[0].parameters["aero.drag_area"] = estimate;
    const BlindScore result = score({key}, {answer});
    ASSERT_EQ(result.parameter_errors.size(), 1u);
    EXPECT_NEAR(result.parameter_errors[0], 3, 1e-9);
    EXPECT_EQ(result.figure("parameter_2sd").hits, 0);
}

TEST(BlindScore, CaseWithoutAnswerHasFailed) {
    CaseAnswer broken = answerOf("b", Verdict::nothing);
    broken.failure = "the log has no time";
    const BlindScore result = score({keyOf("a", CaseKind::none), keyOf("b", CaseKind::none)}, {broken});
    EXPECT_EQ(result.failed, 2);
    EXPECT_EQ(result.figure("false_alarm").of, 0);
}

TEST(BlindScore, WhatNoCaseTellsIsNoZero) {
    const BlindScore none = score({keyOf("a", CaseKind::none)}, {answerOf("a", Verdict::nothing)});
    const std::string text = scoreText(none);
    EXPECT_NE(text.find("single effects: none was blamed"), std::string::npos) << text;
    EXPECT_NE(text.find("there are no cases of one effect"), std::string::npos) << text;
    const auto json = nlohmann::json::parse(scoreJson(none));
    for (const char* name : {"median_closure", "mean_credible_set", "median_credible_set"})
        EXPECT_TRUE(json.at(name).is_null()) << name;
    EXPECT_TRUE(json.at("figures").at("named_first").at("share").is_null());

    CaseAnswer half = answerOf("a", Verdict::explained, {"drag"}), unseen = answerOf("b", Verdict::explained, {"drag"});
    half.closure_obtained = 0.5;
    const BlindScore some =
        score({keyOf("a", CaseKind::one, {"drag"}), keyOf("b", CaseKind::one, {"drag"})}, {half, unseen});
    EXPECT_EQ(some.median_closure, 0.5) << "of those that could be driven again";
}

TEST(BlindScore, AnswerReadsBack) {
    CaseAnswer answer = answerOf("a", Verdict::ambiguous, {"drag", "mass"});
    answer.alternatives = {{"drag", "mu"}, {"mass", "mu"}};
    answer.effects[0].parameters["mass"].value = 1500;
    answer.confusable = {"mass"};
    answer.closure_obtained = 0.9;
    answer.baselines = {.largest_reduction = "mass", .bic = "none"};
    EXPECT_EQ(answerText(parseAnswer(answerText(answer), "a.json")), answerText(answer));
    EXPECT_THROW(parseAnswer("{}", "a.json"), LoadError);
}

TEST(BlindScore, ClosureObtainedIsTheShareOfTheSquaredGapToTheCleanDrive) {
    const auto log = [](double value) {
        return Log{{{"time", "s", {0, 1, 2}}, {"chassis.yaw_rate", "rad/s", {value, value, value}}}};
    };
    Overlay training, held_out;
    training.extended = training.nominal = log(9);
    held_out.hold_out = true;
    training.recording = held_out.recording = "slalom";
    held_out.nominal = log(0.4);
    held_out.extended = log(0.1);
    EXPECT_NEAR(obtainedClosure({training, held_out}, {{"slalom", log(0)}}), 1 - 1.0 / 16, 1e-12);
    EXPECT_TRUE(std::isnan(obtainedClosure({training}, {{"slalom", log(0)}})));
}

}  // namespace
}  // namespace tread
