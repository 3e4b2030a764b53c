// The answer of a diagnosis in words: headline, parts of the gap, and numbers of the car.

#include <gtest/gtest.h>

#include "base/text/concat.h"
#include "diagnose/answer/changed_numbers.h"
#include "diagnose/answer/headline.h"
#include "diagnose/answer/parts.h"
#include "diagnose/answer/words.h"
#include "shared/diagnosis_sample.h"

namespace tread::diagnosis_words_test {
namespace {

using diagnose::answer::changedNumbers;
using diagnose::answer::changeInPercent;
using diagnose::answer::Decomposition;
using diagnose::answer::Diagnosis;
using diagnose::answer::effectInWords;
using diagnose::answer::enlargingInWords;
using diagnose::answer::Estimate;
using diagnose::answer::evidenceInWords;
using diagnose::answer::headline;
using diagnose::answer::kindOfForceInWords;
using diagnose::answer::movedNumbers;
using diagnose::answer::numberInWords;
using diagnose::answer::Part;
using diagnose::answer::partInWords;
using diagnose::answer::PartKind;
using diagnose::answer::percentInWords;
using diagnose::answer::RankedEffect;
using diagnose::answer::ToldPart;
using diagnose::answer::toldParts;
using diagnose::answer::unitOf;
using diagnose::answer::Verdict;
using diagnose::answer::vibrationInWords;

Part part(double share) {
    return {share, share, share};
}

// The gap of a car with two causes.
Decomposition twoCauses(double tolerances, double causes, double remainder, double noise) {
    return {.gap = 20,
            .tolerances = part(tolerances),
            .causes = part(causes),
            .remainder = part(remainder),
            .noise = part(noise),
            .each = {{"roll_stiffness", part(0.2), part(0.1)}, {"brake_gain", part(0.5), part(0.4)}}};
}

Diagnosis twoCausesFound() {
    Diagnosis d;
    d.verdict = Verdict::partly_explained;
    d.causes = {"roll_stiffness", "brake_gain"};
    d.effects = {{"brake_gain", 0.97, 40, {}}, {"roll_stiffness", 0.8, 12, {}}, {"brake_fade", 0.2, 8, {}}};
    d.training = twoCauses(0.1, 0.6, 0.12, 0.18);
    return d;
}

TEST(Headline, NamesTheCausesByTheirSharesAndWhatRemains) {
    Diagnosis d = twoCausesFound();
    EXPECT_EQ(headline(d),
              "Mostly brake gain (p = 0.97), with roll stiffness (p = 0.80); 12 % of the gap remains unexplained");
    d.held_out = twoCauses(0.1, 0.5, 0.3, 0.1);
    EXPECT_TRUE(headline(d).ends_with("12 % of the gap remains unexplained (30 % in the held-out drives)"));
    d.verdict = Verdict::explained;
    d.held_out = {};
    d.training.remainder = part(0.001);
    EXPECT_TRUE(headline(d).ends_with("; less than 1 % of the gap remains unexplained")) << headline(d);
    d.training.remainder = part(0);
    EXPECT_TRUE(headline(d).ends_with("; nothing remains unexplained")) << headline(d);
    d.held_out = twoCauses(0.1, 0.8, 0, 0.1);
    EXPECT_TRUE(headline(d).ends_with("; nothing remains unexplained")) << headline(d);
}

// Half of what tolerances and noise leave: 0.72 in all, of which brake_gain explains 0.5 on its own.
TEST(Headline, SaysMostlyOnlyOfACauseOfMoreThanHalf) {
    Diagnosis d = twoCausesFound();
    d.training.each[1].first = part(0.37);
    EXPECT_TRUE(headline(d).starts_with("Mostly brake gain"));
    d.training.each[1].first = part(0.35);
    EXPECT_EQ(headline(d),
              "Brake gain (p = 0.97), with roll stiffness (p = 0.80) explains 60 % of the gap; 12 % of the gap remains "
              "unexplained");
}

TEST(Headline, DoesNotSayMostlyOfACauseWhereTolerancesExplainMore) {
    Diagnosis d = twoCausesFound();
    d.verdict = Verdict::explained;
    d.training = twoCauses(0.7, 0.2, 0, 0.1);
    d.training.each = {{"brake_gain", part(0.18), part(0.18)}, {"roll_stiffness", part(0.02), part(0.02)}};
    EXPECT_EQ(
        headline(d),
        "Brake gain (p = 0.97), with roll stiffness (p = 0.80); tolerances alone would explain 70 % of the gap, but "
        "with unlikely values; 10 % is noise; nothing remains unexplained");
}

TEST(Headline, OfCausesBesideAPatternDoesNotSayThatNothingRemains) {
    Diagnosis d = twoCausesFound();
    d.training.remainder = part(0);
    EXPECT_EQ(
        headline(d),
        "Mostly brake gain (p = 0.97), with roll stiffness (p = 0.80); nothing of the gap exceeds noise, but what "
        "remains has a pattern");
    d.held_out = twoCauses(0.1, 0.5, 0.3, 0.1);
    EXPECT_TRUE(headline(d).ends_with(
        "; nothing of the gap exceeds noise (30 % in the held-out drives), but what remains has a pattern"));
}

TEST(Headline, NamesRivalsAndTheDriveThatWouldTell) {
    Diagnosis d = twoCausesFound();
    d.verdict = Verdict::ambiguous;
    d.causes = {"brake_gain"};
    d.alternatives = {{"brake_fade"}};
    d.training.each.erase(d.training.each.begin());
    EXPECT_EQ(headline(d),
              "Mostly brake gain or brake fade: these drives cannot tell them apart; 12 % of the gap remains "
              "unexplained");
    d.next = {{"scenarios/a.yaml", {"mass"}, {}, 90}, {"scenarios/b.yaml", {"brake_gain"}, {"brake_fade"}, 34}};
    EXPECT_TRUE(headline(d).starts_with(
        "Mostly brake gain or brake fade: these drives cannot tell them apart; scenarios/b.yaml would; 12 %"));
}

TEST(Headline, NamesWhatAllRivalsHoldBeforeThem) {
    Diagnosis d = twoCausesFound();
    d.verdict = Verdict::ambiguous;
    d.alternatives = {{"brake_gain", "mass"}, {"aero_lift", "brake_gain"}};
    EXPECT_EQ(headline(d),
              "Mostly brake gain (p = 0.97), with roll stiffness or mass or aero lift, which these drives cannot tell "
              "apart; 12 % of the gap remains unexplained");
}

TEST(DiagnosisWords, OfANextDriveClaimNoMoreThanAModelCanKnow) {
    EXPECT_EQ(evidenceInWords({"a.yaml", {"mass"}, {}, 34.4}), "34 nats");
    EXPECT_EQ(evidenceInWords({"a.yaml", {"mass"}, {}, 259508}), "more than 100 nats");
}

TEST(Headline, OfAnUnknownCauseSaysWhatRemainsAndWhatIsExplained) {
    Diagnosis d = twoCausesFound();
    d.verdict = Verdict::unknown;
    d.training = twoCauses(0.1, 0.2, 0.6, 0.1);
    d.unexplained.generalised_force = "lateral";
    EXPECT_EQ(headline(d),
              "Mostly unknown: 60 % of the gap remains unexplained; brake gain (p = 0.97), with roll stiffness (p = "
              "0.80) explains 20 % of the gap; missing force: lateral");
    d.training = twoCauses(0.6, 0.1, 0.2, 0.1);
    EXPECT_EQ(headline(d),
              "Mostly tolerances: they explain 60 % of the gap; 20 % of the gap remains unexplained; brake gain (p = "
              "0.97), with roll stiffness (p = 0.80) explains 10 % of the gap; missing force: lateral");
    d.training = twoCauses(0.1, 0.2, 0.6, 0.1);
    d.training.causes = part(-0.3);
    EXPECT_NE(headline(d).find("roll stiffness (p = 0.80) makes the gap 30 % larger; "), std::string::npos);
    d.causes.clear();
    d.training.each.clear();
    d.unexplained.law.follows = "ay|ay|", d.unexplained.law.unit = "m2/s4";
    EXPECT_EQ(headline(d),
              "Mostly unknown: 60 % of the gap remains unexplained; no effect in the catalogue explains it; missing "
              "force: lateral, it follows ay|ay|");
    d.unexplained.law.unit.clear();
    EXPECT_TRUE(headline(d).ends_with("missing force: lateral, it is constant"));
    d.training.remainder = part(0), d.held_out = twoCauses(0.1, 0.2, 0.3, 0.4);
    EXPECT_EQ(
        headline(d),
        "Unknown: nothing of the gap exceeds noise (30 % in the held-out drives), but what remains is constant; no "
        "effect in the catalogue explains it; missing force: lateral");
}

TEST(Headline, OfAnUnknownCauseSaysThatItLooksLikeAnErrorOfAnInstrument) {
    Diagnosis d = twoCausesFound();
    d.causes.clear(), d.training.each.clear();
    d.verdict = Verdict::unknown;
    d.training = twoCauses(0.1, 0, 0.8, 0.1);
    d.unexplained.generalised_force = "longitudinal";
    d.unexplained.instrument = "speed timing";
    EXPECT_EQ(headline(d),
              "Mostly unknown: 80 % of the gap remains unexplained; no effect in the catalogue explains it; it looks "
              "like an error of an instrument: speeds that come late or early in some drives");
    d.training.remainder = part(0);
    EXPECT_EQ(
        headline(d),
        "Unknown: nothing of the gap exceeds noise, but what remains looks like an error of an instrument: speeds "
        "that come late or early in some drives; no effect in the catalogue explains it");
    d.unexplained.law.follows = "ay|ay|", d.unexplained.law.unit = "m2/s4";
    EXPECT_EQ(headline(d),
              "Unknown: nothing of the gap exceeds noise, but what remains follows ay|ay|; no effect in the catalogue "
              "explains it; missing force: longitudinal");
}

TEST(Headline, OfAnUnknownCauseSaysThatTheCarVibrates) {
    Diagnosis d = twoCausesFound();
    d.causes.clear();
    d.verdict = Verdict::unknown;
    d.training = twoCauses(0.1, 0, 0.6, 0.3);
    d.training.each.clear();
    d.unexplained.vibration = {
        .frequency = 5, .growth = {{"chassis.roll_rate", 21.6}, {"chassis.ay", 6.2}}, .gain = 12};
    EXPECT_EQ(headline(d),
              "Mostly unknown: 60 % of the gap remains unexplained, and the car vibrates at 5 Hz, unlike before the "
              "change; no effect in the catalogue explains it");
    d.training = twoCauses(0.1, 0, 0, 0.9);
    d.training.each.clear();
    EXPECT_EQ(headline(d),
              "Unknown: nothing of the gap exceeds noise, but the car vibrates at 5 Hz, unlike before the change; no "
              "effect in the catalogue explains it");
    EXPECT_EQ(vibrationInWords(d.unexplained.vibration),
              "a vibration at 5 Hz that the references lack: roll rate 22 times, lateral acceleration 6.2 times their "
              "amplitude (12 nats)");
    EXPECT_EQ(vibrationInWords({}), "");
}

TEST(Headline, OfCausesSaysThatTheCarVibratesBeside) {
    Diagnosis d = twoCausesFound();
    d.verdict = Verdict::partly_explained;
    d.training = twoCauses(0.1, 0.5, 0.2, 0.2);
    d.unexplained.vibration = {.frequency = 5, .growth = {{"chassis.ay", 6.2}}, .gain = 12};
    EXPECT_NE(headline(d).find("; 20 % of the gap remains unexplained, and the car vibrates at 5 Hz, unlike before"),
              std::string::npos)
        << headline(d);
}

TEST(Headline, OfNothingSaysWhatTheGapConsistsOf) {
    Diagnosis d;
    d.verdict = Verdict::nothing;
    d.training = {
        .gap = 3, .tolerances = part(0.6), .causes = {}, .remainder = part(0.03), .noise = part(0.37), .each = {}};
    EXPECT_EQ(headline(d),
              "Nothing found: tolerances explain 60 % of the gap, 37 % is noise, 3 % of the gap remains unexplained");
    d.effects = {{.name = "drag", .probability = 0.93, .parameters = {}}};
    EXPECT_TRUE(headline(d).starts_with("Nothing certain, perhaps drag (p = 0.93): tolerances explain 60 %"))
        << headline(d);
    d.effects = {{.name = "drag", .probability = 0.4, .parameters = {}},
                 {.name = "mass", .probability = 0.2, .parameters = {}},
                 {.name = "wind", .probability = 0.1, .parameters = {}},
                 {.name = "grade", .probability = 0.09, .parameters = {}}};
    EXPECT_TRUE(
        headline(d).starts_with("Nothing certain, perhaps drag (p = 0.40), mass (p = 0.20) or wind (p = 0.10): "))
        << headline(d);
    d.probability_of_nothing = 0.4, d.probability_of_unknown = 0.2;
    EXPECT_TRUE(headline(d).starts_with("Nothing found: "));
    d.nuisance = {{"mass", {.z = -3.5}}, {"wheelbase", {.z = 2.9}}};
    EXPECT_TRUE(headline(d).ends_with("; but mass moved by more than 3 standard deviations of its tolerance"));
    d.nuisance = {{"a", {.z = -3.5}}, {"b", {.z = 5}}, {"c", {.z = 4}}, {"d", {.z = 3.1}}, {"e", {.z = -3.2}}};
    EXPECT_TRUE(headline(d).ends_with(
        "; but b, c, a and 2 other numbers moved by more than 3 standard deviations of their tolerances"))
        << headline(d);
}

TEST(Headline, OfDrivesThatShowNothingSaysSo) {
    EXPECT_EQ(headline(Diagnosis{}), "Not testable: these drives excite all effects too weakly");
}

double sumOf(const std::vector<ToldPart>& parts, double ToldPart::*number) {
    double sum = 0;
    for (const ToldPart& one : parts) sum += one.*number;
    return sum;
}

// 0.6 in all, of which 0.1 is what either of them explains.
TEST(Parts, OverlappingCausesHaveAPartOfTheirOwn) {
    const std::vector<ToldPart> parts = toldParts(twoCauses(0.1, 0.6, 0.12, 0.18));
    ASSERT_EQ(parts.size(), 6u);
    EXPECT_EQ(partInWords(parts[1]), "brake gain");
    EXPECT_EQ(parts[1].share, 0.4);
    EXPECT_EQ(partInWords(parts[2]), "roll stiffness");
    EXPECT_EQ(partInWords(parts[3]), "shared by brake gain and roll stiffness");
    EXPECT_NEAR(parts[3].share, 0.1, 1e-12);
    EXPECT_FALSE(parts[3].interval.has_value());
    EXPECT_NEAR(sumOf(parts, &ToldPart::share), 1, 1e-12);
    EXPECT_NEAR(sumOf(parts, &ToldPart::drawn), 1, 1e-12);
}

// Alone they explain 0.1 and 0.2; each explains 0.3 and 0.4 after the other, and 0.5 both.
TEST(Parts, CausesThatNeedEachOtherHaveAPartThatOnlyBothExplain) {
    Decomposition gap = twoCauses(0.1, 0.5, 0.2, 0.2);
    gap.each = {{"roll_stiffness", part(0.1), part(0.3)}, {"brake_gain", part(0.2), part(0.4)}};
    const std::vector<ToldPart> parts = toldParts(gap);
    EXPECT_EQ(parts[1].share, 0.2);
    EXPECT_EQ(parts[2].share, 0.1);
    EXPECT_EQ(parts[3].kind, PartKind::together);
    EXPECT_EQ(partInWords(parts[3]), "brake gain and roll stiffness only together");
    EXPECT_NEAR(parts[3].share, 0.2, 1e-12);
    EXPECT_NEAR(sumOf(parts, &ToldPart::share), 1, 1e-12);
}

TEST(Parts, ThatMakeTheGapLargerAreDrawnAsNothingAndSaid) {
    Decomposition gap = twoCauses(-0.2, 0.3, 0.7, 0.2);
    gap.each = {{"roll_stiffness", part(0.0), part(-0.1)}, {"brake_gain", part(0.4), part(0.3)}};
    const std::vector<ToldPart> parts = toldParts(gap);
    EXPECT_NEAR(sumOf(parts, &ToldPart::share), 1, 1e-12);
    EXPECT_NEAR(sumOf(parts, &ToldPart::drawn), 1, 1e-12);
    EXPECT_EQ(parts[0].drawn, 0);
    EXPECT_NEAR(parts[4].drawn, 0.7 / 1.3, 1e-12);
    EXPECT_EQ(
        enlargingInWords(gap),
        (std::vector<std::string>{"Fitting the tolerances alone increases the gap by 20 % of that of the nominal car.",
                                  "Roll stiffness increases the gap by 10 % of that of the nominal car."}));
}

TEST(Parts, WithoutACauseAreTolerancesRemainderAndNoise) {
    Decomposition gap = twoCauses(0.5, 0, 0.3, 0.2);
    gap.each.clear();
    const std::vector<ToldPart> parts = toldParts(gap);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_NEAR(sumOf(parts, &ToldPart::drawn), 1, 1e-12);
    EXPECT_TRUE(enlargingInWords(gap).empty());
}

TEST(Numbers, OfBothAxlesThatChangeAlikeAreOne) {
    const Estimate stiffer{105000, 6000, 95100, 114900, 141800, false},
        softer{90000, 6000, 80000, 99000, 141800, false};
    const RankedEffect both{"a", 1, 1, {{"front.tyre.parameters.cFy", stiffer}, {"rear.tyre.parameters.cFy", stiffer}}};
    ASSERT_EQ(changedNumbers(both).size(), 1u);
    EXPECT_EQ(numberInWords(changedNumbers(both).front().paths), "front, rear: lateral carcass stiffness");
    const RankedEffect each{"a", 1, 1, {{"front.tyre.parameters.cFy", stiffer}, {"rear.tyre.parameters.cFy", softer}}};
    EXPECT_EQ(changedNumbers(each).size(), 2u);
}

TEST(Numbers, AreSaidInTheWordsOfTheirDescription) {
    EXPECT_EQ(numberInWords({"front.tyre.lambda.Ky"}), "front: scales the cornering stiffness");
    EXPECT_EQ(numberInWords({"rear.left.grip"}), "rear left: factor on the friction of the tyre of this wheel");
    EXPECT_EQ(numberInWords({"instruments.yaw_rate.gain"}), "yaw rate: reading divided by the true value");
    EXPECT_EQ(numberInWords({"instruments.ay.gain"}), "lateral acceleration: reading divided by the true value");
    EXPECT_EQ(numberInWords({"instruments.steering_wheel_angle.bias"}),
              "steering wheel angle: reading at a true value of zero");
    EXPECT_EQ(numberInWords({"instruments.latency"}).find(": "), std::string::npos);
    EXPECT_TRUE(numberInWords({"wind.x in oval"}).ends_with(" in oval"));
    EXPECT_EQ(effectInWords("yaw_rate_delay@can"), "yaw rate delay (can)");
    EXPECT_EQ(kindOfForceInWords("lateral error"),
              "errors of the side forces, in proportion to the lateral acceleration");
}

TEST(Numbers, ZeroOfAnInstrumentHasTheUnitOfItsChannel) {
    for (const auto& [instrument, unit] : {std::pair{"ay", "m/s2"},
                                           {"yaw_rate", "rad/s"},
                                           {"roll", "rad"},
                                           {"speed", "m/s"},
                                           {"wheel_speed", "rad/s"},
                                           {"steering_wheel_angle", "rad"},
                                           {"further.chassis.ay@can", "m/s2"},
                                           {"command", "N"}})
        EXPECT_EQ(unitOf(concat({"instruments.", instrument, ".bias"})), unit) << instrument;
    EXPECT_EQ(unitOf("instruments.ay.gain"), "-");
    EXPECT_EQ(unitOf("instruments.ay.delay"), "s");
}

TEST(Numbers, ChangeInPercentOfTheirNominalValue) {
    const auto change = [](double value, double neutral, double sd) {
        return changeInPercent({.value = value, .sd = sd, .neutral = neutral}, "+-");
    };
    EXPECT_EQ(change(0.34, 0.5, 0.02), "-32 +- 4 %");
    EXPECT_EQ(change(-1.5, -1, 0.123), "-50 +- 12 %");
    EXPECT_EQ(change(1.0034, 1, 0.0004), "+0.34 +- 0.04 %");
    EXPECT_EQ(change(1.0034, 1, 0.0096), "+0 +- 1 %");
    EXPECT_EQ(change(1.5, 1, 0), "+50 +- 0 %");
    EXPECT_EQ(change(1, 0, 1), "");
    EXPECT_EQ(change(0, 0, 1), "");
    EXPECT_EQ(change(-0.39, 0.001, 0), "");
    EXPECT_EQ(change(-0.009, 0.011, 0.019), "");
    EXPECT_EQ(percentInWords(0.123), "12 %");
    EXPECT_EQ(percentInWords(0.004), "less than 1 %");
    EXPECT_EQ(percentInWords(0), "0 %");
}

TEST(Numbers, ThatMovedByAToleranceOrStandAtTheirEndAreTold) {
    const auto moved = movedNumbers({{"a", {.z = 0.9}},
                                     {"b", {.z = -1.5}},
                                     {"c", {.z = 0.2, .at_bound = true}},
                                     {"d", {.z = 2}},
                                     {"e", {.z = 0, .at_bound = true}}});
    ASSERT_EQ(moved.size(), 3u);
    EXPECT_EQ(moved[0].name + moved[1].name + moved[2].name, "dbc");
}

}  // namespace
}  // namespace tread::diagnosis_words_test
