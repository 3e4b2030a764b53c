// What users get of a diagnosis: the page, and the car with the effect.

#include <gtest/gtest.h>

#include <numbers>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/answer/diagnosis_text.h"
#include "diagnose/answer/vehicle_with_effect.h"
#include "diagnose/answer/words.h"
#include "recording/subject.h"
#include "report/diagnosis_report.h"
#include "shared/diagnosis_sample.h"
#include "shared/page_charts.h"
#include "shared/scratch.h"
#include "shared/vehicle_run.h"

namespace tread {
namespace {

using diagnose::answer::ConfusablePair;
using diagnose::answer::Diagnosis;
using diagnose::answer::diagnosisJson;
using diagnose::answer::diagnosisText;
using diagnose::answer::Overlay;
using diagnose::answer::probabilityInWords;
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
    for (const char* said :
         {"The gap is caused by tyre_relaxation (p = 0.97).", "▶ tyre relaxation", "an unknown cause",
          "front.tyre.parameters.cFy = 105000 ± 6000 N/m (90 %: 95100 to 114900; nominal 141800)",
          "92 % of the closable gap is closed with the effect (90 %: 88 % to 95 %)", "Held-out drives",
          "(held out): yaw rate", "sine_sweep", "scenarios/straight_braking_100.yaml", "brake fade, brake gain",
          "a slower signal, held", "2310 simulations in 41 s"})
        EXPECT_TRUE(contains(html, said)) << said;
    EXPECT_LT(html.find("The gap is caused by"), html.find("Which effect"));
}

TEST(DiagnosisPage, BlamesAndAlarmsOnlyWhatDeservesIt) {
    Diagnosis d = shared::sampleDiagnosis();
    d.causes.clear();
    d.verdict = Verdict::nothing;
    d.how_far.in_sample = true;
    const std::string html = page(d);
    EXPECT_FALSE(contains(html, "▶"));
    EXPECT_TRUE(contains(html, "nothing found"));
    EXPECT_TRUE(contains(html, "because none was held out"));
    EXPECT_FALSE(contains(html, "Held-out drives"));
}

TEST(DiagnosisPage, TellsTheLawThatAForceOfUnknownCauseFollows) {
    Diagnosis d = shared::sampleDiagnosis();
    const char* const said =
        "a force follows the magnitude of the lateral acceleration: lateral -53.5 N, yaw 102 N m per m/s2 (157 nats)";
    EXPECT_FALSE(contains(page(d), "a force follows"));
    d.unexplained.law = {.follows = "the magnitude of the lateral acceleration",
                         .unit = "m/s2",
                         .coefficients = {{"lateral", -53.5}, {"yaw", 102.4}},
                         .gain = 157.2};
    EXPECT_TRUE(contains(page(d), std::string("In addition to the best answer, ") + said));
    d.verdict = Verdict::unknown;
    d.causes.clear();
    d.effects.clear();
    d.unexplained.law.generalised_force = "yaw";
    EXPECT_TRUE(contains(page(d), std::string("A force acts that no effect of the catalogue explains: ") + said));
    EXPECT_TRUE(contains(diagnosisText(d), std::string("no effect of the catalogue; ") + said));
}

TEST(DiagnosisPage, IsMadeOfAnEmptyDiagnosisToo) {
    const std::string html = page(Diagnosis{});
    EXPECT_TRUE(contains(html, "not testable"));
    EXPECT_TRUE(contains(html, "</html>"));
}

TEST(DiagnosisPage, NamesOfTheUserCannotBreakIt) {
    Diagnosis d = shared::sampleDiagnosis();
    d.effects[1].name = "<script>alert(1)</script>";
    d.where.recordings = {{"<b>", 1}};
    d.where.channels_of_recording = {{"<b>", {{"chassis.ay", 1}}}};
    d.overlays[0].recording = "</figure>";
    const std::string html = page(d);
    EXPECT_FALSE(contains(html, "<script>alert"));
    EXPECT_FALSE(contains(html, "<td class=\"\"><b>"));
    EXPECT_TRUE(contains(html, "&lt;/figure&gt; (held out)"));
}

TEST(DiagnosisPage, ShadesWhatTheTolerancesAllowWhereThatIsKnown) {
    const std::string html = page(shared::sampleDiagnosis());
    const nlohmann::json charts = chartsOf(html);
    ASSERT_EQ(charts.size(), 4u);
    for (const nlohmann::json& chart : charts) {
        const bool held_out = chart.at("title").get<std::string>().find("(held out)") != std::string::npos;
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
    EXPECT_TRUE(contains(page(d), "damping and steering delay, steering delay and grip"));
    EXPECT_EQ(diagnosisJson(d).at("alternatives"), nlohmann::ordered_json::array({"grip", "steering_delay"}));
}

TEST(DiagnosisPage, ShowsTheNearestPairsThatCannotBeToldApartAndCountsTheOthers) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_FALSE(contains(page(d), "nearest of"));
    const ConfusablePair far{"grip", "camber_thrust", 0.6, 5.9, "sine_sweep"};
    d.confusable.resize(11, far);
    EXPECT_TRUE(contains(page(d), "the 10 nearest of 11"));
}

TEST(DiagnosisPage, SaysWhatIsTakenOffWhereItComparedWithReferences) {
    Diagnosis d = shared::sampleDiagnosis();
    EXPECT_FALSE(contains(page(d), "Measured: minus the gap"));
    d.compared = true;
    EXPECT_TRUE(contains(page(d), "Measured: minus the gap between the nominal car and the reference"));
    EXPECT_TRUE(contains(page(d), "Compared with"));
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
    d.causes = {"grade"};
    d.effects = {{"grade", 1, 50, {{"road.grade", {0.01, 0.001, 0.008, 0.012, 0, false}}}}};
    EXPECT_TRUE(contains(vehicleWithEffectYaml(nominal, d),
                         "# Not numbers of the car, and therefore not in this file:\n#   grade: road.grade"));
    EXPECT_EQ(withCauses(nominal, d).road.grade, 0.01);
}

}  // namespace
}  // namespace tread
