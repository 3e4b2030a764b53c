// What users get of a diagnosis: the page, and the car with the effect.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/answer/diagnosis_text.h"
#include "diagnose/answer/parts.h"
#include "diagnose/answer/vehicle_with_effect.h"
#include "diagnose/answer/words.h"
#include "recording/subject.h"
#include "report/diagnosis_report.h"
#include "shared/diagnosis_sample.h"
#include "shared/page_charts.h"
#include "shared/scratch.h"
#include "shared/vehicle_run.h"

namespace tread::diagnosis_report_test {
namespace {

using diagnose::answer::closedShare;
using diagnose::answer::ConfusablePair;
using diagnose::answer::Diagnosis;
using diagnose::answer::diagnosisJson;
using diagnose::answer::diagnosisText;
using diagnose::answer::isAnswered;
using diagnose::answer::Overlay;
using diagnose::answer::probabilityInWords;
using diagnose::answer::unseenEffects;
using diagnose::answer::vehicleWithEffectYaml;
using diagnose::answer::Verdict;
using diagnose::answer::withCauses;
using recording::Subject;

std::string page(const Diagnosis& diagnosis) {
    return diagnosisReport({.title = "Diagnosis", .vehicle = "compact", .version = "0.1", .diagnosis = diagnosis});
}

bool contains(const std::string& text, const std::string& what) {
    return text.find(what) != std::string::npos;
}

TEST(DiagnosisPage, SaysTheAnswerFirstAndWhatItRestsOn) {
    const std::string html = page(shared::sampleDiagnosis());
    for (const char* said : {"<title>Diagnosis: Mostly tyre relaxation (p = 0.97); 1 % of the gap",
                             "▶ tyre relaxation",
                             "an unknown cause",
                             "front, rear: lateral carcass stiffness",
                             "141800 → 105000 N/m",
                             "-26 ± 4 %",
                             "front.tyre.parameters.cFy, rear.tyre.parameters.cFy; 90 %: 95100 to 114900 N/m",
                             "Drives used for fitting: the gap is 17 times that of a perfect model",
                             "Held-out drives: the gap is 13 times",
                             "36 % to 50 %",
                             "(held out): yaw rate",
                             "1920 ± 50 → 2010",
                             "+2.4",
                             "at the end of its plausible range",
                             "scenarios/straight_braking_100.yaml",
                             "brake fade, brake gain",
                             "a slower signal, held",
                             "6.5 s",
                             "Lateral disturbances",
                             "1 of 2 kinds of disturbances and errors have at most 1.5 times their usual size",
                             "2310 simulations in 41 s"})
        EXPECT_TRUE(contains(html, said)) << said;
    EXPECT_LT(html.find("Mostly tyre relaxation"), html.find("Parts of the gap"));
    EXPECT_FALSE(contains(html, "The car before"));
}

// Lengths of the parts of the bars on a page.
std::vector<double> lengthsOf(const std::string& html) {
    const std::string sign = "flex-grow:";
    std::vector<double> lengths;
    for (std::size_t at = html.find(sign); at != std::string::npos; at = html.find(sign, at + 1))
        lengths.push_back(std::stod(html.substr(at + sign.size())));
    return lengths;
}

TEST(DiagnosisPage, DrawsTheGapAsABarOfItsParts) {
    Diagnosis d = shared::sampleDiagnosis();
    d.held_out = {};
    const std::string html = page(d);
    EXPECT_EQ(lengthsOf(html), (std::vector<double>{0.5, 0.43, 0.01, 0.06}));
    EXPECT_TRUE(contains(html, ": tolerances 50 %, tyre relaxation 43 %, unexplained 1 %, noise 6 %\">"));
    EXPECT_TRUE(contains(html, "No drive is held out"));
}

TEST(DiagnosisPage, SaysOfACauseThatItMakesTheGapLarger) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_FALSE(contains(page(d), "increases the gap"));
    d.held_out.causes = d.held_out.each[0].first = d.held_out.each[0].last = {-0.06, -0.1, 0};
    d.held_out.remainder.share = 0.52;
    EXPECT_TRUE(contains(page(d), "Tyre relaxation increases the gap by 6 % of that of the nominal car."));
    double sum = 0;
    for (const double length : lengthsOf(page(d))) sum += length;
    EXPECT_NEAR(sum, 2, 1e-3) << "two bars";
}

TEST(DiagnosisPage, BlamesOnlyWhatDeservesIt) {
    Diagnosis d = shared::sampleDiagnosis();
    d.causes.clear();
    d.training.each.clear();
    d.held_out = {};
    d.verdict = Verdict::nothing;
    d.probability_of_nothing = 0.3;
    EXPECT_TRUE(contains(page(d), "nothing certain"));
    d.probability_of_nothing = 0.6;
    const std::string html = page(d);
    EXPECT_FALSE(contains(html, "▶"));
    EXPECT_TRUE(contains(html, "nothing found"));
    EXPECT_FALSE(contains(html, "What the causes mean"));
    EXPECT_TRUE(contains(html, "tolerances fitted"));
    EXPECT_FALSE(contains(html, "with the causes"));
}

TEST(DiagnosisPage, TellsOfTheCarBefore) {
    Diagnosis d = shared::sampleDiagnosis();
    d.before = {.nominal = 9.1, .fitted = 2.3, .moved = {{"mass", {1700, 9, 1684, 10, 1.6, false}}}};
    EXPECT_TRUE(contains(page(d), "9.1 for the nominal car, 2.3 after the fit"));
    EXPECT_TRUE(contains(page(d), "1684 ± 10 → 1700"));
    EXPECT_TRUE(contains(diagnosisText(d), "references 9.1 -> 2.3 of the floor; mass 1684 -> 1700 (+1.6 sd)"));
}

TEST(DiagnosisPage, TellsTheLawThatAForceOfUnknownCauseFollows) {
    Diagnosis d = shared::sampleDiagnosis();
    const char* const said =
        "a force that follows the magnitude of the lateral acceleration: lateral -53.5 N, yaw 102 N m per m/s2 (157 "
        "nats)";
    EXPECT_FALSE(contains(page(d), "a force that follows"));
    d.unexplained.law = {.follows = "the magnitude of the lateral acceleration",
                         .unit = "m/s2",
                         .coefficients = {{"lateral", -53.5}, {"yaw", 102.4}},
                         .gain = 157.2};
    EXPECT_TRUE(contains(page(d), std::string("In addition to the best answer, ") + said));
    d.verdict = Verdict::unknown;
    d.causes.clear();
    d.effects.clear();
    d.unexplained.law.generalised_force = "yaw";
    EXPECT_TRUE(contains(page(d), std::string("<p>A") + (said + 1)));
    EXPECT_TRUE(contains(diagnosisText(d), std::string("no effect in the catalogue; ") + said));
}

TEST(DiagnosisPage, IsMadeOfAnEmptyDiagnosisToo) {
    const std::string html = page(Diagnosis{});
    EXPECT_TRUE(contains(html, "not testable"));
    EXPECT_TRUE(contains(html, "</html>"));
}

TEST(DiagnosisPage, NamesOfTheUserCannotBreakIt) {
    Diagnosis d = shared::sampleDiagnosis();
    d.effects[1].name = "<script>alert(1)</script>";
    d.causes = {"<i>cause</i>"};
    d.training.each[0].name = d.effects[0].name = "<i>cause</i>";
    d.cuts[0].recording = "<u>";
    d.where.recordings = {{"<b>", 1}};
    d.where.channels_of_recording = {{"<b>", {{"chassis.ay", 1}}}};
    d.overlays[0].recording = "</figure>";
    const std::string html = page(d);
    EXPECT_FALSE(contains(html, "<script>alert"));
    EXPECT_FALSE(contains(html, "<td class=\"\"><b>"));
    EXPECT_FALSE(contains(html, "<i>cause"));
    EXPECT_TRUE(contains(html, "&lt;i&gt;cause&lt;/i&gt; 43 %"));
    EXPECT_FALSE(contains(html, "<u>"));
    EXPECT_TRUE(contains(html, "&lt;/figure&gt; (held out)"));
}

TEST(DiagnosisPage, ShadesWhatTheTolerancesAllowWhereThatIsKnown) {
    const nlohmann::json charts = chartsOf(page(shared::sampleDiagnosis()));
    ASSERT_EQ(charts.size(), 8u) << "two channels of two drives, and below each what is left";
    for (std::size_t c = 0; c < charts.size(); c += 2) {
        const nlohmann::json& chart = charts[c];
        const bool held_out = chart.at("title").get<std::string>().find("(held out)") != std::string::npos;
        EXPECT_EQ(held_out, c >= 4) << "the drive with the larger gap comes first";
        ASSERT_EQ(chart.contains("envelope"), !held_out) << chart.at("title");
        if (held_out) continue;
        EXPECT_EQ(chart.at("envelope").at("name"), "what the tolerances allow (2 sd)");
        const auto low = unpacked<float>(chart.at("envelope").at("low")),
                   high = unpacked<float>(chart.at("envelope").at("high")),
                   nominal = unpacked<float>(chart.at("curves").at(1).at("values"));
        const bool yaw_rate = chart.at("title").get<std::string>().ends_with("yaw rate");
        const double half = yaw_rate ? 2 * 0.02 * 180 / std::numbers::pi : 2 * 0.3;  // deg/s, m/s2
        ASSERT_EQ(low.size(), nominal.size());
        for (std::size_t i = 0; i < nominal.size(); ++i) {
            EXPECT_NEAR(high[i] - nominal[i], half, 1e-4);
            EXPECT_NEAR(nominal[i] - low[i], half, 1e-4);
        }
    }
}

TEST(DiagnosisPage, ShowsWhatEachStageLeavesBesideTheNoise) {
    const Diagnosis d = shared::sampleDiagnosis();
    const nlohmann::json charts = chartsOf(page(d));
    const nlohmann::json& left = charts.at(1);
    EXPECT_EQ(left.at("title"), "Measured minus model");
    EXPECT_EQ(left.at("marks"), nlohmann::json::array({6.5})) << "not compared from there on";
    EXPECT_EQ(left.at("curves").at(0).at("name"), "nominal");
    EXPECT_EQ(left.at("curves").at(1).at("name"), "with the causes");
    const Overlay& drive = d.overlays[1];
    const auto nominal = unpacked<float>(left.at("curves").at(0).at("values")),
               high = unpacked<float>(left.at("envelope").at("high"));
    const auto& measured = drive.measured.find("chassis.yaw_rate")->values;
    const auto& model = drive.nominal.find("chassis.yaw_rate")->values;
    ASSERT_EQ(nominal.size(), measured.size());
    constexpr double kDegrees = 180 / std::numbers::pi;
    for (std::size_t i = 0; i < measured.size(); i += 50) {
        EXPECT_NEAR(nominal[i], kDegrees * (measured[i] - model[i]), 1e-4);
        EXPECT_NEAR(high[i], kDegrees * 0.004, 1e-4);
    }
}

TEST(DiagnosisPage, FoldsAwayTheDrivesWithTheSmallestGaps) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_FALSE(contains(page(d), "<details><summary>"));
    for (const char* name : {"a", "b"}) d.overlays.push_back(d.overlays[0]), d.overlays.back().recording = name;
    EXPECT_TRUE(contains(page(d), "<summary>1 other drive</summary>"));
    EXPECT_LT(page(d).find("1 other drive"), page(d).find("b (held out): yaw rate"));
}

TEST(DiagnosisPage, HasNoShadingInItsWordsWithoutOneInItsCharts) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_TRUE(contains(page(d), "Shaded: "));
    for (Overlay& overlay : d.overlays) overlay.allowed = {};
    EXPECT_FALSE(contains(page(d), "Shaded: "));
}

TEST(DiagnosisText, NamesTheAxleOnlyWhereSideForcesAreMostOfWhatIsMissing) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_TRUE(contains(diagnosisText(d), "force: yaw 50 %, lateral 40 %, roll 7 %; front axle side force 71 %"));
    d.where.axle_force = {{"front", 0.2}, {"rear", 0.8}};
    EXPECT_TRUE(contains(diagnosisText(d), "rear axle side force 80 %"));
    d.where.generalised_force = {{"longitudinal", 0.9}, {"lateral", 0.1}};
    EXPECT_FALSE(contains(diagnosisText(d), "axle side force"));
}

TEST(DiagnosisPage, NamesWhatElseItCouldBeWholeAndTheJsonEveryEffectOfItOnce) {
    Diagnosis d = shared::sampleDiagnosis();
    d.causes = {"tyre_relaxation", "damping"};
    d.alternatives = {{"damping", "steering_delay"}, {"steering_delay", "grip"}};
    EXPECT_TRUE(contains(page(d), "Could also be damping and steering delay, or steering delay and grip."));
    EXPECT_EQ(diagnosisJson(d).at("rivals").size(), 2u);
    EXPECT_EQ(diagnosisJson(d).at("alternatives"), nlohmann::ordered_json::array({"grip", "steering_delay"}));
}

TEST(DiagnosisPage, ShowsTheNearestPairsThatCannotBeToldApartAndCountsTheOthers) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_FALSE(contains(page(d), "most similar of"));
    const ConfusablePair far{"grip", "camber_thrust", 0.6, 5.9, "sine_sweep"};
    d.confusable.resize(11, far);
    EXPECT_TRUE(contains(page(d), "the 10 most similar of 11"));
}

TEST(DiagnosisPage, SaysWhatIsTakenOffWhereItComparedWithReferences) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_FALSE(contains(page(d), "Measured values are shown minus the gap"));
    d.compared = true;
    EXPECT_TRUE(contains(page(d), "Measured values are shown minus the gap between the nominal car and the reference"));
    EXPECT_TRUE(contains(page(d), "Compared with"));
}

TEST(DiagnosisReport, DoesNotCallCausesUnknownThatItNames) {
    Diagnosis d = shared::sampleDiagnosis();
    d.verdict = Verdict::unknown;
    ASSERT_FALSE(d.causes.empty());
    EXPECT_TRUE(contains(page(d), "✗ cause mostly unknown"));
    d.causes.clear();
    EXPECT_TRUE(contains(page(d), "✗ cause unknown"));
}

// The sign of the badge is the exit status of `tread diagnose`, except where some effect is likely and none is certain.
TEST(DiagnosisReport, TheBadgeIsGoodWhereTheQuestionIsAnswered) {
    Diagnosis d = shared::sampleDiagnosis();
    d.probability_of_nothing = 1;
    for (const Verdict verdict : {Verdict::explained, Verdict::nothing, Verdict::ambiguous, Verdict::partly_explained,
                                  Verdict::unknown, Verdict::not_testable}) {
        d.verdict = verdict;
        EXPECT_EQ(contains(page(d), "verdict good\">✓"), isAnswered(d));
        EXPECT_EQ(contains(page(d), "verdict bad\">✗"), !isAnswered(d));
    }
    EXPECT_FALSE(isAnswered(d));
    d.verdict = Verdict::ambiguous;
    EXPECT_TRUE(isAnswered(d));
    d.verdict = Verdict::nothing;
    d.probability_of_nothing = 0.3;
    EXPECT_TRUE(contains(page(d), "verdict bad\">✗")) << "some effect acts, none is certain";
}

// By hand, from the numbers that stand there.
TEST(DiagnosisReport, TheShareThatIsClosedFollowsFromTheNumbersOnThePage) {
    const Diagnosis d = shared::sampleDiagnosis();
    const auto json = diagnosisJson(d);
    for (const char* drives : {"training", "held_out"}) {
        const auto& gap = json.at(drives);
        const auto share = [&](const char* part) { return gap.at(part).at("share").get<double>(); };
        const double by_hand = 1 - share("remainder") / (1 - share("noise"));
        EXPECT_NEAR(json.at("closed").at(drives).get<double>(), by_hand, 1e-12);
    }
    for (const std::string& said : {page(d), diagnosisText(d)})
        EXPECT_TRUE(contains(said, "1 - unexplained 2.0 / (100 - noise 8.0) = 98 %"));
    EXPECT_TRUE(contains(page(d), "1 - unexplained 1.0 / (100 - noise 6.0) = 99 %"));
    const diagnose::answer::GapLevels levels{4, 3, 2, 1};
    EXPECT_NEAR(closedShare(levels, levels.extended), (16.0 - 4) / (16 - 1), 1e-12);
    EXPECT_TRUE(std::isnan(closedShare({1, 1, 1, 1}, 1))) << "nothing can be closed";
}

// An unknown cause may be likely and yet have too little evidence to be told: the table of rivals then still has "no
// effect" first, and the remainder says the same as the answer.
TEST(DiagnosisReport, AnUnknownCauseThatIsNotToldDoesNotContradictTheAnswer) {
    Diagnosis d = shared::sampleDiagnosis();
    d.verdict = Verdict::nothing;
    d.causes.clear();
    d.training.each.clear();
    d.probability_of_unknown = 0.8, d.probability_of_nothing = 0.6 * 0.2;
    d.effects.resize(1);
    d.effects[0].probability = 0.3;
    d.unexplained.beyond_ordinary = 4;
    EXPECT_TRUE(contains(page(d), ">0.600</td>"));
    EXPECT_TRUE(contains(page(d), "there may be an unknown cause (p = 0.80)"));
    EXPECT_TRUE(contains(page(d), "too few to report an unknown cause"));
    d.verdict = Verdict::unknown;
    EXPECT_TRUE(contains(page(d), "it is larger than that of an ordinary drive by 4 nats"));
}

TEST(DiagnosisReport, TellsAVibrationThatTheReferencesLack) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_FALSE(contains(page(d), "a vibration at"));
    EXPECT_FALSE(contains(diagnosisText(d), "a vibration at"));
    d.verdict = Verdict::partly_explained;
    d.unexplained.beyond_ordinary = -0.2;
    d.unexplained.vibration = {.frequency = 5, .growth = {{"chassis.ay", 6.2}}, .gain = 12};
    const std::string told = "a vibration at 5 Hz that the references lack: lateral acceleration 6.2 times";
    EXPECT_TRUE(contains(page(d), "no more than in an ordinary drive")) << "the remainder is another matter";
    EXPECT_TRUE(contains(page(d), "There is " + told));
    EXPECT_TRUE(contains(diagnosisText(d), told));
    EXPECT_EQ(diagnosisJson(d)["unexplained"]["vibration"]["growth"]["chassis.ay"], 6.2);
}

TEST(DiagnosisReport, WhatIsNamedIsNotListedAsNotSeen) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_EQ(unseenEffects(d), (std::vector<std::string>{"brake_fade", "brake_gain"}));
    d.causes = {"brake_gain"};
    d.alternatives = {{"brake_fade"}};
    EXPECT_TRUE(unseenEffects(d).empty());
    EXPECT_FALSE(contains(diagnosisText(d), "NOT SEEN"));
    EXPECT_FALSE(contains(page(d), "would not show"));
}

TEST(DiagnosisReport, SaysWhatWasRuledOutAndWhy) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_FALSE(contains(page(d), "cannot be the answer"));
    d.ruled_out = {{{"grip", "dampers"}, 31, "one drive supports it and the others contradict it"}};
    EXPECT_TRUE(contains(page(d), "These have evidence but cannot be the answer"));
    EXPECT_TRUE(contains(page(d), "grip and dampers"));
    EXPECT_TRUE(contains(page(d), "one drive supports it and the others contradict it"));
}

TEST(DiagnosisText, IsShortAndInTheOrderOfTheAnswer) {
    Diagnosis d = shared::sampleDiagnosis();
    d.alternatives = {{"steering_delay"}};
    d.ruled_out = {
        {{"tyre_relaxation", "dampers"}, 31, "one of its effects closes no more of the gap than chance could"}};
    for (int i = 0; i < 30; ++i) {
        d.expected_evidence["hidden_" + std::to_string(i)] = 1;
        d.cuts.push_back({"drive", 3, 0.4});
    }
    const std::string text = diagnosisText(d);
    std::size_t at = 0;
    for (const char* headline : {"Mostly tyre relaxation", "\nGAP       17 times", "\nWHERE     ", "\nWHICH     tyre_",
                                 "\nMOVED     ", "\nREMAINS   1 % of the gap", "\nRIVALS    steering delay",
                                 "\nRULED OUT tyre relaxation and dampers (31 nats): one of its effects",
                                 "\nLEFT OUT  sine_sweep after 6.5 s: 19 % of its rows", "\nNEXT      scenarios/",
                                 "\nNOT SEEN  32 of 35 effects"}) {
        const std::size_t next = text.find(headline, at);
        ASSERT_NE(next, std::string::npos) << headline << "\n" << text;
        at = next;
    }
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 25);
    EXPECT_TRUE(contains(text, "tolerances 50 %, tyre relaxation 43 %, unexplained 1 %, noise 6 %")) << text;
    EXPECT_TRUE(contains(text, "front, rear: lateral carcass stiffness 141800 -> 105000 N/m (-26 +- 4 %)")) << text;
}

TEST(DiagnosisJson, HasThePartsTheCutsAndWhereTheRestIs) {
    const auto json = diagnosisJson(shared::sampleDiagnosis());
    EXPECT_EQ(json.at("parts").at("training").at(1).at("part"), "tyre relaxation");
    EXPECT_EQ(json.at("cuts").at(0).at("share"), 0.19);
    EXPECT_EQ(json.at("nuisance").at("mass").at("nominal"), 1350);
    EXPECT_NEAR(json.at("unexplained").at("channels").at("chassis.yaw_rate").get<double>(), 0.75, 1e-12);
}

TEST(DiagnosisText, NothingIsCertain) {
    EXPECT_EQ(probabilityInWords(0.967), "p = 0.97");
    EXPECT_EQ(probabilityInWords(0.9999), "p > 0.99");
}

TEST(CarWithEffect, HasTheFittedNumbersOfTheCausesAndReadsBack) {
    Subject nominal;
    nominal.vehicle = shared::compact();
    Diagnosis d = shared::sampleDiagnosis();
    const Scratch scratch;
    const std::string yaml = vehicleWithEffectYaml(nominal, d);
    const VehicleParams car = loadVehicle(scratch.file("car.yaml", yaml));
    EXPECT_EQ(car.front.tyre.parameters.cFy, 105000);
    EXPECT_EQ(car.rear.tyre.parameters.cFy, 105000);
    EXPECT_EQ(car.steering.delay, 0) << "is not blamed";
    EXPECT_TRUE(
        contains(yaml, "#   tyre_relaxation: front.tyre.parameters.cFy = 1.05e+05 N/m (+- 6e+03), nominal 1.418e+05"));
    // With references, the effect is beside the numbers of the car before as these show it.
    d.compared = true;
    d.before.moved = {{"front.suspension.spring", {.value = 18000, .sd = 900, .nominal = 20000, .z = -2}},
                      {"front.tyre.parameters.cFy", {.value = 150000, .sd = 9000, .nominal = 141800, .z = 0.2}}};
    const std::string compared = vehicleWithEffectYaml(nominal, d);
    const VehicleParams changed = loadVehicle(scratch.file("changed.yaml", compared));
    EXPECT_EQ(changed.front.suspension.spring, 18000);
    EXPECT_EQ(changed.front.tyre.parameters.cFy, 105000);
    EXPECT_TRUE(contains(compared,
                         "# The car before the change, as fitted to its drives:\n"
                         "#   front.suspension.spring = 1.8e+04 N/m (+- 9e+02), nominal 2e+04\n"));
    EXPECT_TRUE(contains(compared, "(+- 6e+03), before 1.418e+05"));
    d.before.moved.clear();
    d.causes = {"grade"};
    d.effects = {{"grade", 1, 50, {{"road.grade", {0.01, 0.001, 0.008, 0.012, 0, false}}}}};
    EXPECT_TRUE(contains(vehicleWithEffectYaml(nominal, d),
                         "# Not numbers of the car, and therefore not in this file:\n#   grade: road.grade"));
    EXPECT_EQ(withCauses(nominal, d).road.grade, 0.01);
}

}  // namespace
}  // namespace tread::diagnosis_report_test
