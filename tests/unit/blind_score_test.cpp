// Scoring of a blind check, against hand-made keys and answers and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/math/random.h"
#include "blind/score/bands.h"
#include "blind/score/claims.h"
#include "blind/score/score.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "tread/problem.h"

namespace tread::blind_score_test {
namespace {

using blind::answers::answerText;
using blind::answers::CaseAnswer;
using blind::answers::obtainedClosure;
using blind::answers::parseAnswer;
using blind::key::CaseKey;
using blind::key::CaseKind;
using blind::key::Family;
using blind::key::SealedKey;
using blind::score::bandsInWords;
using blind::score::BlindScore;
using blind::score::calibrationError;
using blind::score::calibrationErrorByChance;
using blind::score::Claim;
using blind::score::claimsOf;
using blind::score::Count;
using blind::score::Figure;
using blind::score::Interval;
using blind::score::Outcome;
using blind::score::outcomeOf;
using blind::score::reliability;
using blind::score::score;
using blind::score::scoreJson;
using blind::score::scoreText;
using blind::score::wilson;
using blind::score::wordsOf;
using diagnose::answer::Overlay;
using diagnose::answer::RankedEffect;
using diagnose::answer::Verdict;

// Each effect has a detectability and separation of `nats`.
CaseKey keyOf(const std::string& name, CaseKind kind, std::vector<std::string> effects = {}, double nats = 50) {
    CaseKey key;
    key.name = name;
    key.kind = kind;
    for (const std::string& effect : effects) key.shows[effect] = {.nats = nats, .rival = "", .separation = nats};
    key.effects = std::move(effects);
    return key;
}

// An outsider, beside the effects if there are any.
CaseKey outsideOf(const std::string& name, std::vector<std::string> effects = {}, Family family = Family::first) {
    CaseKey key = keyOf(name, effects.empty() ? CaseKind::outside : CaseKind::mixed, effects);
    key.outsider = "flutter";
    key.family = family;
    key.generalised_forces = {"yaw"};
    key.shows["flutter"] = {.nats = 300, .rival = "", .separation = 200};
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
    return answer;
}

BlindScore scoreOf(std::vector<CaseKey> keys, const std::vector<CaseAnswer>& answers) {
    SealedKey key;
    key.cases = std::move(keys);
    return score(key, answers);
}

// "hits/of".
std::string ratio(const Count& count) {
    return std::to_string(count.hits) + "/" + std::to_string(count.of);
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

TEST(BlindScore, FewClaimsThatAreRightAsOftenAsTheyStateScatter) {
    // One claim of p is p off if wrong and 1 - p if right. Two of 0.5: both right or both wrong, with half the chance,
    // are one off. In bins of their own, their distances add.
    EXPECT_NEAR(calibrationErrorByChance(reliability({{0.3, true}})), 2 * 0.3 * 0.7, 1e-12);
    EXPECT_NEAR(calibrationErrorByChance(reliability({{0.5, true}, {0.5, true}})), 0.25, 1e-12);
    EXPECT_NEAR(calibrationErrorByChance(reliability({{0.3, true}, {0.8, false}})), 0.21 + 0.16, 1e-12);
    EXPECT_EQ(calibrationErrorByChance(reliability({{1, true}, {1, false}})), 0);
    EXPECT_EQ(calibrationErrorByChance(reliability({})), 0);
    // Many are normally distributed about their mean.
    const std::vector<Claim> many(400, Claim{0.8, true});
    EXPECT_NEAR(calibrationErrorByChance(reliability(many)), std::sqrt(2 / std::numbers::pi * 0.16 / 400), 2e-4);
}

// ---- One effect ----

TEST(BlindScore, SingleCauseIsNamedFirstOrBesideOthers) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::one, {"drag"}), keyOf("b", CaseKind::one, {"drag"}),
                                    keyOf("c", CaseKind::one, {"drag"}), keyOf("d", CaseKind::one, {"drag"})};
    CaseAnswer either = answerOf("c", Verdict::ambiguous, {"mass", "drag"});
    either.causes = {"mass"};
    either.alternatives = {{"drag"}};
    const BlindScore result =
        scoreOf(keys, {answerOf("a", Verdict::explained, {"drag"}), answerOf("b", Verdict::explained, {"drag", "mass"}),
                       either, answerOf("d", Verdict::nothing)});
    EXPECT_EQ(ratio(result.figure("named_first")), "2/4");
    EXPECT_EQ(ratio(result.figure("named")), "3/4");
    EXPECT_EQ(ratio(result.figure("detected")), "3/4");
    EXPECT_EQ(ratio(result.figure("in_credible_set")), "3/4");
    EXPECT_EQ(result.confusion.at("drag").at("drag + mass"), 1);
    EXPECT_EQ(result.confusion.at("drag").at("drag or mass"), 1);
    EXPECT_EQ(result.mean_credible_set, 1.25);
}

TEST(BlindScore, SinglesAreCountedInTheBandOfTheKey) {
    std::vector<CaseKey> keys;
    std::vector<CaseAnswer> answers;
    for (const double nats : {5.99, 6.0, 21.99, 22.0, 99.0, 100.0}) {
        const std::string name = std::to_string(nats);
        keys.push_back(keyOf(name, CaseKind::one, {"drag"}, nats));
        answers.push_back(answerOf(name, Verdict::explained, {nats < 22 ? "mass" : "drag"}));
    }
    keys.back().shows["drag"].separation = 5.99;
    const BlindScore result = scoreOf(keys, answers);
    EXPECT_EQ(ratio(result.figure("named_first")), "3/6");
    EXPECT_EQ(ratio(result.figure("named_first", "band_0")), "0/1");
    EXPECT_EQ(ratio(result.figure("named_first", "band_1")), "0/2");
    EXPECT_EQ(ratio(result.figure("named_first", "band_2")), "2/2");
    EXPECT_EQ(ratio(result.figure("named_first", "band_3")), "1/1");
    EXPECT_EQ(ratio(result.figure("named_first", "testable_told_apart")), "2/2");
    EXPECT_EQ(ratio(result.figure("named_first", "testable_alike")), "1/1");
    EXPECT_EQ(result.figure("named_first", "testable_told_apart").target, 0.95);
    EXPECT_EQ(result.figure("named_first").target, 0) << "nobody asked for it of effects that do not show";
    EXPECT_THROW(result.figure("named_first", "band_9"), std::out_of_range);
}

TEST(BlindScore, CredibleSetMayHoldNothingOnlyWhereNothingShows) {
    CaseAnswer faint = answerOf("a", Verdict::nothing), clear = answerOf("b", Verdict::nothing);
    faint.credible_set = clear.credible_set = {"none"};
    const BlindScore result =
        scoreOf({keyOf("a", CaseKind::one, {"drag"}, 5), keyOf("b", CaseKind::one, {"drag"}, 6)}, {faint, clear});
    EXPECT_EQ(ratio(result.figure("in_credible_set", "band_0")), "1/1");
    EXPECT_EQ(ratio(result.figure("in_credible_set", "band_1")), "0/1");
}

// ---- Two, none, small ----

TEST(BlindScore, PairIsBothInAnyOrderOrPartlyNamed) {
    std::vector<CaseKey> keys;
    for (const char* name : {"a", "b", "c", "d", "e"}) keys.push_back(keyOf(name, CaseKind::two, {"drag", "mass"}));
    CaseAnswer doubtful = answerOf("d", Verdict::ambiguous, {"drag", "mass"});
    doubtful.alternatives = {{"drag", "mu"}};
    const BlindScore result = scoreOf(
        keys, {answerOf("a", Verdict::explained, {"mass", "drag"}), answerOf("b", Verdict::explained, {"mass"}),
               answerOf("c", Verdict::explained, {"mu"}), doubtful, answerOf("e", Verdict::explained, {"drag", "mu"})});
    EXPECT_EQ(ratio(result.figure("pair_both")), "1/5");
    EXPECT_EQ(ratio(result.figure("pair_only_true")), "2/5");
    EXPECT_EQ(ratio(result.figure("pair_one_first")), "4/5");
}

TEST(BlindScore, PairsAreCountedByTheWeakerAndByTheStronger) {
    CaseKey uneven = keyOf("a", CaseKind::two, {"drag", "mass"}), faint = keyOf("b", CaseKind::two, {"drag", "mass"});
    uneven.shows["drag"].nats = 7, uneven.shows["mass"].nats = 250;
    faint.shows["drag"].nats = 2, faint.shows["mass"].nats = 21;
    const BlindScore result = scoreOf({uneven, faint}, {answerOf("a", Verdict::explained, {"mass", "drag"}),
                                                        answerOf("b", Verdict::explained, {"mass"})});
    EXPECT_EQ(ratio(result.figure("pair_both", "band_0")), "0/1");
    EXPECT_EQ(ratio(result.figure("pair_both", "band_1")), "1/1");
    EXPECT_EQ(ratio(result.figure("pair_both", "stronger_band_1")), "0/1");
    EXPECT_EQ(ratio(result.figure("pair_both", "stronger_band_3")), "1/1");
    EXPECT_EQ(ratio(result.figure("pair_one_first", "one_testable")), "1/1");
    EXPECT_EQ(ratio(result.figure("pair_both", "testable_told_apart")), "0/0");
    EXPECT_EQ(bandsInWords(uneven), "6 to 22, 100 and more");
}

TEST(BlindScore, FalseAlarmsAreEffectsAndUnknownsAlike) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::none), keyOf("b", CaseKind::none), keyOf("c", CaseKind::none),
                                    keyOf("d", CaseKind::none)};
    const BlindScore result =
        scoreOf(keys, {answerOf("a", Verdict::nothing), answerOf("b", Verdict::not_testable),
                       answerOf("c", Verdict::unknown), answerOf("d", Verdict::explained, {"drag"})});
    EXPECT_EQ(ratio(result.figure("false_alarm")), "2/4");
    EXPECT_EQ(ratio(result.figure("detected")), "0/0");
}

TEST(BlindScore, SmallEffectMayBeNamedButNothingElse) {
    std::vector<CaseKey> keys;
    for (const char* name : {"a", "b", "c", "d", "e"}) keys.push_back(keyOf(name, CaseKind::small, {"drag"}, 1));
    CaseAnswer either = answerOf("d", Verdict::ambiguous, {"mass"});
    either.alternatives = {{"drag"}};
    const BlindScore result =
        scoreOf(keys, {answerOf("a", Verdict::nothing), answerOf("b", Verdict::explained, {"drag"}),
                       answerOf("c", Verdict::unknown), either, answerOf("e", Verdict::explained, {"drag", "mass"})});
    EXPECT_EQ(ratio(result.figure("small_blamed")), "2/5");
    EXPECT_EQ(ratio(result.figure("small_blamed", "band_0")), "2/5");
}

// ---- Outsiders ----

TEST(BlindScore, OutsiderIsUnknownInItsPlaceOrWronglyBlamedByFamily) {
    const std::vector<CaseKey> keys{outsideOf("a"), outsideOf("b", {}, Family::second), outsideOf("c")};
    CaseAnswer right = answerOf("a", Verdict::unknown), elsewhere = answerOf("b", Verdict::unknown);
    right.generalised_force = "yaw";
    elsewhere.generalised_force = "roll";
    const BlindScore result = scoreOf(keys, {right, elsewhere, answerOf("c", Verdict::explained, {"mu"})});
    EXPECT_EQ(ratio(result.figure("unknown")), "2/3");
    EXPECT_EQ(ratio(result.figure("unknown", "first_family")), "1/2");
    EXPECT_EQ(ratio(result.figure("unknown", "second_family")), "1/1");
    EXPECT_EQ(ratio(result.figure("unknown", "band_3")), "2/3");
    EXPECT_EQ(ratio(result.figure("unknown_force")), "1/2");
    EXPECT_EQ(ratio(result.figure("outside_blamed")), "1/3");
    EXPECT_EQ(ratio(result.figure("outside_blamed", "second_family")), "0/1");
}

TEST(BlindScore, MixedCaseAsksForTheEffectForTheRemainderAndForBoth) {
    std::vector<CaseKey> keys;
    for (const char* name : {"a", "b", "c", "d"}) keys.push_back(outsideOf(name, {"drag"}));
    keys[0].shows["drag"].nats = 10;
    CaseAnswer both = answerOf("c", Verdict::unknown, {"drag"});
    const BlindScore result =
        scoreOf(keys, {answerOf("a", Verdict::explained, {"drag"}), answerOf("b", Verdict::unknown), both,
                       answerOf("d", Verdict::explained, {"mass"})});
    EXPECT_EQ(ratio(result.figure("mixed_effect")), "2/4");
    EXPECT_EQ(ratio(result.figure("mixed_effect", "band_1")), "1/1") << "by what the effect shows";
    EXPECT_EQ(ratio(result.figure("mixed_remainder")), "2/4");
    EXPECT_EQ(ratio(result.figure("mixed_remainder", "band_3")), "2/4") << "by what the outsider shows";
    EXPECT_EQ(ratio(result.figure("mixed_both")), "1/4");
    EXPECT_EQ(ratio(result.figure("unknown")), "0/0");
    EXPECT_EQ(result.confusion.at("drag + outside: flutter").at("drag + unknown"), 1);
}

// ---- Outcomes ----

TEST(BlindScore, EveryCaseHasOneOutcome) {
    const CaseKey one = keyOf("", CaseKind::one, {"drag"}), two = keyOf("", CaseKind::two, {"drag", "mass"});
    const CaseKey none = keyOf("", CaseKind::none), outside = outsideOf(""), mixed = outsideOf("", {"drag"});
    const auto named = [](std::vector<std::string> causes) {
        return answerOf("", Verdict::explained, std::move(causes));
    };
    const CaseAnswer unknown = answerOf("", Verdict::unknown), nothing = answerOf("", Verdict::nothing);
    EXPECT_EQ(outcomeOf(one, named({"drag"})), Outcome::right);
    EXPECT_EQ(outcomeOf(one, named({"mass", "drag"})), Outcome::partly);
    EXPECT_EQ(outcomeOf(one, named({"mass"})), Outcome::wrong);
    EXPECT_EQ(outcomeOf(one, unknown), Outcome::unknown);
    EXPECT_EQ(outcomeOf(one, nothing), Outcome::nothing);
    EXPECT_EQ(outcomeOf(two, named({"mass", "drag"})), Outcome::right);
    EXPECT_EQ(outcomeOf(two, named({"mass"})), Outcome::partly);
    EXPECT_EQ(outcomeOf(none, nothing), Outcome::right);
    EXPECT_EQ(outcomeOf(none, unknown), Outcome::unknown);
    EXPECT_EQ(outcomeOf(none, named({"drag"})), Outcome::wrong);
    EXPECT_EQ(outcomeOf(outside, unknown), Outcome::right);
    EXPECT_EQ(outcomeOf(outside, answerOf("", Verdict::unknown, {"drag"})), Outcome::partly);
    EXPECT_EQ(outcomeOf(outside, named({"drag"})), Outcome::wrong);
    EXPECT_EQ(outcomeOf(mixed, answerOf("", Verdict::unknown, {"drag"})), Outcome::right);
    EXPECT_EQ(outcomeOf(mixed, named({"drag"})), Outcome::partly);
    EXPECT_EQ(outcomeOf(mixed, unknown), Outcome::unknown);
    CaseAnswer broken;
    broken.failure = "no time";
    EXPECT_EQ(outcomeOf(none, broken), Outcome::no_answer);
}

TEST(BlindScore, RowsOfOutcomesHoldEveryCaseOnce) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::one, {"drag"}), keyOf("b", CaseKind::one, {"mass"}),
                                    keyOf("c", CaseKind::one, {"drag"}, 7), keyOf("d", CaseKind::none)};
    const BlindScore result =
        scoreOf(keys, {answerOf("a", Verdict::explained, {"drag"}), answerOf("b", Verdict::nothing),
                       answerOf("c", Verdict::nothing), answerOf("d", Verdict::nothing)});
    ASSERT_EQ(result.outcomes.size(), 3u);
    EXPECT_EQ(result.outcomes[0].bands, "6 to 22");
    EXPECT_EQ(result.outcomes[1].bands, "22 to 100");
    EXPECT_EQ(result.outcomes[1].counts, (std::array<int, 6>{1, 0, 1, 0, 0, 0}));
    EXPECT_EQ(result.outcomes[2].kind, CaseKind::none);
}

// ---- Baselines ----

TEST(BlindScore, BaselinesAreCountedBesideWhereTheyAreKnown) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::one, {"drag"}),
                                    keyOf("b", CaseKind::one, {"drag"}),
                                    keyOf("c", CaseKind::none),
                                    keyOf("d", CaseKind::one, {"drag"}),
                                    keyOf("e", CaseKind::two, {"drag", "mass"}),
                                    outsideOf("f"),
                                    keyOf("g", CaseKind::small, {"drag"}, 1)};
    std::vector<CaseAnswer> answers{answerOf("a", Verdict::explained, {"drag"}),
                                    answerOf("b", Verdict::explained, {"drag"}),
                                    answerOf("c", Verdict::nothing),
                                    answerOf("d", Verdict::explained, {"drag"}),
                                    answerOf("e", Verdict::explained, {"drag"}),
                                    answerOf("f", Verdict::unknown),
                                    answerOf("g", Verdict::nothing)};
    answers[0].baselines = {.largest_reduction = "drag", .bic = "drag"};
    answers[1].baselines = {.largest_reduction = "mass", .bic = "drag"};
    answers[2].baselines = {.largest_reduction = "mass", .bic = "none"};
    answers[4].baselines = {.largest_reduction = "mass", .bic = "mu"};
    answers[5].baselines = {.largest_reduction = "mass", .bic = "none"};
    answers[6].baselines = {.largest_reduction = "mass", .bic = "drag"};
    const BlindScore result = scoreOf(keys, answers);
    const Figure& first = result.figure("named_first");
    EXPECT_EQ(ratio(first), "3/3");
    EXPECT_EQ(ratio(first.largest_reduction), "1/2");
    EXPECT_EQ(ratio(first.bic), "2/2");
    EXPECT_EQ(ratio(result.figure("false_alarm").largest_reduction), "1/1");
    EXPECT_EQ(ratio(result.figure("false_alarm").bic), "0/1");
    EXPECT_EQ(ratio(result.figure("pair_both").largest_reduction), "0/1") << "it names one effect";
    EXPECT_EQ(ratio(result.figure("pair_only_true").largest_reduction), "1/1");
    EXPECT_EQ(ratio(result.figure("pair_only_true").bic), "0/1");
    EXPECT_EQ(ratio(result.figure("unknown").bic), "0/0") << "it cannot call anything unknown";
    EXPECT_EQ(ratio(result.figure("outside_blamed").largest_reduction), "1/1");
    EXPECT_EQ(ratio(result.figure("small_blamed").largest_reduction), "1/1");
    EXPECT_EQ(ratio(result.figure("small_blamed").bic), "0/1");
    EXPECT_EQ(ratio(result.figure("named_first", "band_2").largest_reduction), "1/2");
}

// ---- Claims and numbers ----

TEST(BlindScore, WrongAndConfidentIsCountedOverEveryClaim) {
    const std::vector<CaseKey> keys{keyOf("a", CaseKind::none), keyOf("b", CaseKind::none),
                                    keyOf("c", CaseKind::one, {"drag"})};
    const BlindScore result =
        scoreOf(keys, {answerOf("a", Verdict::explained, {"mu"}, 0.95), answerOf("b", Verdict::explained, {"mu"}, 0.6),
                       answerOf("c", Verdict::explained, {"drag"}, 0.99)});
    EXPECT_EQ(ratio(result.figure("wrong_confident")), "1/3");
    EXPECT_EQ(ratio(result.figure("wrong_confident", "kind_none")), "1/2");
    EXPECT_EQ(ratio(result.figure("wrong_confident", "kind_one")), "0/1");
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

TEST(BlindScore, NothingIsARightClaimBelowSixNatsAndUnknownWhereAnOutsiderActs) {
    CaseAnswer nothing = answerOf("a", Verdict::nothing), unknown = answerOf("a", Verdict::unknown);
    nothing.probability_of_nothing = 0.9;
    unknown.probability_of_unknown = 0.7;
    const auto right = [](const CaseKey& key, const CaseAnswer& answer) {
        const std::vector<Claim> claims = claimsOf(key, answer);
        return claims.size() == 1 && claims.front().right;
    };
    EXPECT_TRUE(right(keyOf("a", CaseKind::none), nothing));
    EXPECT_TRUE(right(keyOf("a", CaseKind::small, {"drag"}, 5.9), nothing));
    EXPECT_FALSE(right(keyOf("a", CaseKind::small, {"drag"}, 6), nothing));
    EXPECT_TRUE(right(keyOf("a", CaseKind::one, {"drag"}, 5.9), nothing));
    EXPECT_FALSE(right(keyOf("a", CaseKind::one, {"drag"}, 6), nothing));
    EXPECT_FALSE(right(outsideOf("a"), nothing));
    EXPECT_TRUE(right(outsideOf("a"), unknown));
    EXPECT_TRUE(right(outsideOf("a", {"drag"}), unknown));
    EXPECT_FALSE(right(keyOf("a", CaseKind::none), unknown));
}

TEST(BlindScore, NumbersOfRightCausesAreHitWithinTwoAndMissedAtTheirBound) {
    CaseKey key = keyOf("a", CaseKind::one, {"drag"});
    key.numbers["aero.drag_area"] = {.nominal = 0.6, .value = 0.8, .change = 1};
    key.numbers["aero.lift"] = {.nominal = 0, .value = 0.1, .change = 1};
    key.numbers["aero.pitch"] = {.nominal = 0, .value = 0.1, .change = 1};
    CaseAnswer answer = answerOf("a", Verdict::explained, {"drag", "mass"});
    auto& parameters = answer.effects[0].parameters;
    parameters["aero.drag_area"] = {.value = 0.86, .sd = 0.02};
    parameters["aero.lift"] = {.value = 0.101, .sd = 0.1, .at_bound = true};
    parameters["aero.pitch"] = {.value = 0.11, .sd = 0.01};
    answer.effects[1].parameters["aero.pitch"] = {.value = 9, .sd = 0.1};  // of a wrong cause
    const BlindScore result = scoreOf({key}, {answer});
    ASSERT_EQ(result.number_errors.size(), 3u);
    EXPECT_NEAR(result.number_errors[0].in_sd, 3, 1e-9);
    EXPECT_NEAR(result.number_errors[0].relative, 0.06 / 0.2, 1e-9);
    EXPECT_EQ(result.number_errors[1].in_sd, kInfinity);
    EXPECT_EQ(ratio(result.figure("numbers_2sd")), "1/3");
    EXPECT_NEAR(*result.median_relative_error, 0.1, 1e-9);
    answer.effects[0].parameters["aero.pitch"].sd = 0;
    EXPECT_EQ(ratio(scoreOf({key}, {answer}).figure("numbers_2sd")), "0/3") << "without a standard deviation: a miss";
}

TEST(BlindScore, WithReferencesTheChangeOfANumberCounts) {
    CaseKey key = keyOf("a", CaseKind::one, {"spring_rate"});
    key.numbers["front.suspension.spring"] = {.nominal = 22000, .value = 29000, .change = 1.5};
    CaseAnswer answer = answerOf("a", Verdict::explained, {"spring_rate"});
    answer.compared = true;
    const auto& effects = diagnose::catalogue::effectCatalogue();
    const auto spring =
        std::find_if(effects.begin(), effects.end(), [](const auto& effect) { return effect.name == "spring_rate"; });
    const double by = 1.5 * spring->knobs.front().typical;  // a share of the number
    // The model of the car before has softer springs, and their rate changes by the same share and a little more.
    answer.effects[0].parameters["front.suspension.spring"] = {
        .value = 18000 * (1 + by) + 900, .sd = 1000, .neutral = 18000};
    const auto compared = blind::score::numberErrors(key, answer);
    ASSERT_EQ(compared.size(), 1u);
    EXPECT_NEAR(compared[0].in_sd, 0.9, 1e-9);
    EXPECT_NEAR(compared[0].relative, 900 / (18000 * by), 1e-9);
    answer.compared = false;
    EXPECT_LT(blind::score::numberErrors(key, answer)[0].in_sd, -2) << "then the number itself is known";
}

TEST(BlindScore, ClosureIsCoveredByItsInterval) {
    CaseAnswer inside = answerOf("a", Verdict::explained, {"drag"}), below = answerOf("b", Verdict::nothing);
    inside.closure_low = 0.4, inside.closure_high = 0.6, inside.closure_obtained = 0.5;
    below.closure_obtained = -0.1;
    const BlindScore result = scoreOf(
        {keyOf("a", CaseKind::one, {"drag"}), keyOf("b", CaseKind::one, {"drag"}), keyOf("c", CaseKind::one, {"drag"})},
        {inside, below, answerOf("c", Verdict::explained, {"drag"})});
    EXPECT_EQ(ratio(result.figure("closure_covered")), "1/2") << "of those that could be driven again";
    EXPECT_NEAR(*result.median_closure, 0.2, 1e-12);
}

// ---- What decides ----

std::vector<CaseKey> everyKind() {
    std::vector<CaseKey> keys{keyOf("a", CaseKind::one, {"drag"}),         keyOf("b", CaseKind::one, {"mass"}, 8),
                              keyOf("c", CaseKind::two, {"drag", "mass"}), keyOf("d", CaseKind::none),
                              keyOf("e", CaseKind::small, {"mu"}, 2),      outsideOf("f"),
                              outsideOf("g", {"mu"}, Family::second)};
    keys[2].shows["mass"].separation = 1;
    return keys;
}

TEST(BlindScore, NothingOfAnAnswerDecidesWhatCounts) {
    const std::vector<CaseKey> keys = everyKind();
    const std::vector<std::string> effects{"drag", "mass", "mu"};
    const auto drawn = [&](std::uint64_t seed) {
        Random random(seed);
        std::vector<CaseAnswer> answers;
        for (const CaseKey& key : keys) {
            const auto verdict = static_cast<Verdict>(static_cast<int>(5 * random.uniform()));
            const bool blamed = verdict == Verdict::explained || verdict == Verdict::ambiguous;
            CaseAnswer answer = answerOf(key.name, verdict);
            if (blamed) answer = answerOf(key.name, verdict, {effects[static_cast<std::size_t>(3 * random.uniform())]});
            if (random.uniform() < 0.2) answer.failure = "too slow";
            answers.push_back(answer);
        }
        return answers;
    };
    const BlindScore first = scoreOf(keys, drawn(1));
    for (std::uint64_t seed = 2; seed <= 40; ++seed) {
        const BlindScore other = scoreOf(keys, drawn(seed));
        for (std::size_t i = 0; i < first.figures.size(); ++i) {
            const std::string& name = first.figures[i].name;
            if (name == "wrong_confident" || name == "numbers_2sd" || name == "unknown_force")
                continue;  // of what is said
            EXPECT_EQ(other.figures[i].of, first.figures[i].of) << name << " " << first.figures[i].group;
        }
    }
}

TEST(BlindScore, WhatAnAnswerExpectsChangesNoCount) {
    const std::vector<CaseKey> keys = everyKind();
    std::vector<CaseAnswer> answers;
    for (const CaseKey& key : keys) answers.push_back(answerOf(key.name, Verdict::explained, {"drag"}, 0.95));
    const std::string plain = scoreJson(scoreOf(keys, answers));
    Random random(3);
    for (int i = 0; i < 20; ++i) {
        for (CaseAnswer& answer : answers)
            for (const char* effect : {"drag", "mass", "mu"}) answer.expected_evidence[effect] = 200 * random.uniform();
        EXPECT_EQ(scoreJson(scoreOf(keys, answers)), plain);
    }
}

TEST(BlindScore, KeyWithoutWhatItsDrivesShowIsRefused) {
    CaseKey key = keyOf("case_007", CaseKind::one, {"drag"});
    key.shows.clear();
    try {
        scoreOf({key}, {answerOf("case_007", Verdict::nothing)});
        ADD_FAILURE() << "no fault";
    } catch (const LoadError& error) {
        EXPECT_NE(std::string(error.what()).find("case_007"), std::string::npos) << error.what();
    }
}

TEST(BlindScore, AnswersWithAndWithoutReferencesNeedTheKeyThatSaysWhatThoseShow) {
    SealedKey key;
    key.cases = {keyOf("a", CaseKind::none)};
    CaseAnswer compared = answerOf("a", Verdict::nothing);
    compared.compared = true;
    EXPECT_THROW(score(key, {compared}), LoadError);
    key.references = true;
    EXPECT_NE(scoreText(score(key, {compared})).find("with references"), std::string::npos);
    EXPECT_THROW(score(key, {answerOf("a", Verdict::nothing)}), LoadError);
}

TEST(BlindScore, CaseWithoutAnswerCountsAsAnsweredWithNothing) {
    CaseAnswer broken = answerOf("b", Verdict::explained, {"drag"});
    broken.failure = "the log has no time";
    const BlindScore result = scoreOf({keyOf("a", CaseKind::none), keyOf("b", CaseKind::one, {"drag"})}, {broken});
    EXPECT_EQ(result.failed, 2);
    EXPECT_EQ(ratio(result.figure("false_alarm")), "0/1");
    EXPECT_EQ(ratio(result.figure("named_first")), "0/1");
    EXPECT_EQ(result.confusion.at("drag").at("no answer"), 1);
    EXPECT_NE(scoreText(result).find("2 of 2 cases without an answer"), std::string::npos);
}

// ---- Text and JSON ----

TEST(BlindScore, TextSaysTheAnswerFirstAndFitsItsWidth) {
    std::vector<CaseKey> keys = everyKind();
    keys[0].effects = {"a_name_of_an_effect_that_is_longer_than_any_of_the_catalogue_is"};
    keys[0].shows[keys[0].effects[0]] = {.nats = 30, .rival = "", .separation = 30};
    std::vector<CaseAnswer> answers;
    for (const CaseKey& key : keys) {
        answers.push_back(answerOf(key.name, Verdict::explained, {"drag"}, 0.95));
        answers.back().baselines = {.largest_reduction = "drag", .bic = "none"};
    }
    const std::string text = scoreText(scoreOf(keys, answers));
    EXPECT_TRUE(text.starts_with("Blind check of 7 cases, NOT frozen: one effect named first in 0 of 2, ")) << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;
    for (const char* word : {"Figures of all cases", "Wilson 95 %", "22 nats and more, distinguishable",
                             "second family", "Outcomes", "Stated probabilities", "by the stronger of two", "99.97 %"})
        EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
}

TEST(BlindScore, TextAndJsonSayWhetherTheCheckIsFrozen) {
    SealedKey key;
    key.cases = {keyOf("a", CaseKind::none)};
    key.program = {.diagnosis = std::string(64, '1'), .scoring = std::string(64, '2')};
    CaseAnswer answer = answerOf("a", Verdict::nothing);
    answer.program = key.program;
    const BlindScore same = score(key, {answer}, key.program);
    EXPECT_TRUE(scoreText(same).starts_with("Blind check of 1 cases, frozen:")) << scoreText(same);
    EXPECT_TRUE(nlohmann::json::parse(scoreJson(same)).at("frozen"));
    answer.program.diagnosis = std::string(64, '3');
    const BlindScore other = score(key, {answer}, key.program);
    EXPECT_NE(
        scoreText(other).find("NOT frozen: the key records program 111111111111, the answers were given by program "
                              "333333333333"),
        std::string::npos)
        << scoreText(other);
    EXPECT_FALSE(nlohmann::json::parse(scoreJson(other)).at("frozen"));
}

TEST(BlindScore, JsonHasEveryFigureAndThoseOfItsGroups) {
    std::vector<CaseAnswer> answers{answerOf("a", Verdict::explained, {"drag"})};
    answers[0].baselines = {.largest_reduction = "mass", .bic = "drag"};
    const auto json = nlohmann::json::parse(scoreJson(scoreOf(everyKind(), answers)));
    const auto& first = json.at("figures").at("named_first");
    EXPECT_EQ(first.at("hits"), 1);
    EXPECT_EQ(first.at("of"), 2);
    EXPECT_EQ(first.at("bic").at("hits"), 1);
    EXPECT_NEAR(first.at("low").get<double>(), wilson(1, 2).low, 1e-12);
    EXPECT_EQ(json.at("groups").at("testable_told_apart").at("figures").at("named_first").at("at_least"), 0.95);
    EXPECT_EQ(json.at("outcomes").size(), 7u);
    EXPECT_EQ(json.at("outcomes")[0].at("nats"), "6 to 22");
    EXPECT_TRUE(json.at("median_closure").is_null());
    EXPECT_TRUE(json.at("median_relative_error").is_null());
}

TEST(BlindScore, WhatNoCaseTellsIsNoZero) {
    const BlindScore none = scoreOf({keyOf("a", CaseKind::none)}, {answerOf("a", Verdict::nothing)});
    const std::string text = scoreText(none);
    EXPECT_NE(text.find("no car could be driven again"), std::string::npos) << text;
    EXPECT_NE(text.find("no such case"), std::string::npos) << text;
    EXPECT_EQ(text.find("one effect:"), std::string::npos) << text;
    EXPECT_TRUE(nlohmann::json::parse(scoreJson(none)).at("figures").at("named_first").at("share").is_null());
}

TEST(BlindScore, AnswerReadsBack) {
    CaseAnswer answer = answerOf("a", Verdict::ambiguous, {"drag", "mass"});
    answer.program = {.diagnosis = "ab", .scoring = "cd"};
    answer.compared = true;
    answer.alternatives = {{"drag", "mu"}, {"mass", "mu"}};
    answer.effects[0].parameters["mass"] = {.value = 1500, .sd = 3, .at_bound = true};
    answer.expected_evidence = {{"drag", 12.5}};
    answer.closure = 0.9;
    answer.baselines = {.largest_reduction = "mass", .bic = "none"};
    const CaseAnswer read = parseAnswer(answerText(answer), "a.json");
    EXPECT_EQ(answerText(read), answerText(answer));
    EXPECT_TRUE(std::isnan(read.closure_obtained));
    EXPECT_EQ(read.effects.at(0).parameters.at("mass").value, 1500);
    EXPECT_EQ(read.verdict, Verdict::ambiguous);
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
}  // namespace tread::blind_score_test
