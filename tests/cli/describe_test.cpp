#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/fields/reference_table.h"
#include "base/text/concat.h"
#include "cli/program.h"
#include "compare/tolerances.h"
#include "diagnose/catalogue/effect.h"
#include "metrics/metrics.h"
#include "recording/diagnosis_file.h"
#include "scenario/scenario.h"
#include "tread/vehicle.h"

namespace tread::describe_test {
namespace {

using diagnose::catalogue::Effect;
using diagnose::catalogue::effectCatalogue;
using diagnose::catalogue::Knob;
using diagnose::catalogue::OwnEffects;
using recording::DiagnosisFile;

using Json = nlohmann::json;

Json described(const std::string& what) {
    const Result result = runProgram({"describe", what, "--json"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    return Json::parse(result.out);
}

Json field(const Json& described, const std::string& path) {
    for (const Json& candidate : described["fields"]) {
        if (candidate["path"] == path) return candidate;
    }
    return nullptr;
}

// What is described, each field in one line.
std::string describedInLines(const std::string& what) {
    setenv("COLUMNS", "10000", 1);
    const Result result = runProgram({"describe", what});
    unsetenv("COLUMNS");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    return result.out;
}

// The lines of a table that begin with a path.
std::size_t linesWith(const std::string& text, const std::string& path) {
    std::istringstream stream(text);
    std::size_t count = 0;
    for (std::string line; std::getline(stream, line);) count += (line + " ").rfind("  " + path + " ", 0) == 0;
    return count;
}

template <class T>
void expectEveryFieldOnce(const std::string& what) {
    const std::string text = describedInLines(what);
    EXPECT_EQ(firstLine(text).find(what + ": "), 0u);
    const Json json = described(what);
    const auto rows = referenceTable<T>();
    EXPECT_EQ(json["fields"].size(), rows.size());
    for (const ReferenceRow& row : rows) {
        EXPECT_EQ(linesWith(text, row.path), 1u) << row.path;
        EXPECT_EQ(field(json, row.path)["meaning"], row.meaning) << row.path;
    }
}

TEST(Describe, ListsEveryFieldOfEveryFile) {
    expectEveryFieldOnce<VehicleParams>("vehicle");
    expectEveryFieldOnce<TyreParams>("tyre");
    expectEveryFieldOnce<Scenario>("scenario");
    expectEveryFieldOnce<Tolerances>("tolerances");
    expectEveryFieldOnce<DiagnosisFile>("diagnosis");
    expectEveryFieldOnce<OwnEffects>("own_effects");
}

TEST(Describe, FieldHasUnitMeaningLimitsPlausibleRangeDefaultAndTolerance) {
    const Json damping = field(described("vehicle"), "front.suspension.damper.bump");
    EXPECT_EQ(damping, (Json{{"path", "front.suspension.damper.bump"},
                             {"unit", "N s/m"},
                             {"meaning", "damping in compression"},
                             {"limits", "at least 0"},
                             {"plausible", "0.5 to 100000"},
                             {"default", "required"},
                             {"tolerance", 0.1}}));
    const std::string text = describedInLines("vehicle");
    EXPECT_NE(text.find("damping in compression (usually known to within 10 %)"), std::string::npos);
    EXPECT_NE(text.find(" plausible "), std::string::npos) << "a column";
    EXPECT_NE(text.find("\nfront: front axle\n"), std::string::npos) << "groups have a headline";
}

// The cells of a column begin at the same place.
TEST(Describe, ColumnsOfAGroupAreAligned) {
    const std::string text = describedInLines("vehicle");
    const std::size_t begin = text.find("\ninertia: ");
    std::istringstream group(text.substr(begin + 1, text.find("\n\n", begin) - begin - 1));
    std::string line;
    std::getline(group, line);
    std::getline(group, line);
    const std::size_t unit = line.find("unit"), meaning = line.find("meaning");
    std::size_t rows = 0;
    while (std::getline(group, line)) {
        EXPECT_EQ(line.substr(unit, 6), "kg m2 ") << line;
        EXPECT_EQ(line.at(meaning - 1), ' ') << line;
        EXPECT_NE(line.at(meaning), ' ') << line;
        ++rows;
    }
    EXPECT_EQ(rows, 4u);
}

TEST(Describe, LogHasTheColumnsOfALog) {
    const Json log = described("log");
    EXPECT_EQ(log["fields"].size(), 1u + 8u + 2u + 16u + 4u * 16u + 2u + 4u + 2u + 3u + 2u + 3u);
    EXPECT_EQ(field(log, "time")["unit"], "s");
    EXPECT_EQ(field(log, "driver.steering_wheel_angle")["unit"], "rad");
    EXPECT_EQ(field(log, "chassis.ay")["unit"], "m/s2");
    EXPECT_EQ(field(log, "wheel.rear_right.load")["unit"], "N");
    EXPECT_EQ(field(log, "driveline.engine_speed")["unit"], "rad/s");
    EXPECT_EQ(runProgram({"describe", "log"}).out.find("default"), std::string::npos) << "columns have none";
}

TEST(Describe, MetricsHaveUnitAndDefinition) {
    const std::string text = describedInLines("metrics");
    EXPECT_EQ(text.find("default"), std::string::npos);
    const Json json = described("metrics");
    std::size_t metrics = 0;
    for (const Manoeuvre& known : manoeuvres()) {
        EXPECT_NE(text.find(concat({"\n", known.name, ": ", known.description, "\n"})), std::string::npos);
        for (const MetricDefinition& metric : known.definitions()) {
            const std::string path = concat({known.name, ".", metric.name});
            EXPECT_EQ(linesWith(text, path), 1u) << path;
            EXPECT_EQ(field(json, path)["unit"], metric.unit) << path;
            EXPECT_EQ(field(json, path)["meaning"], concat({metric.title, ": ", metric.definition})) << path;
            ++metrics;
        }
    }
    EXPECT_EQ(json["fields"].size(), metrics);
    EXPECT_EQ(field(json, "step_steer.tb")["unit"], "s deg");
    EXPECT_EQ(field(json, "coast_down.time_<v>_to_<v-20>_kmh")["meaning"],
              "Time from <v> to <v-20> km/h: time while the speed falls from <v> to <v-20> km/h");
}

TEST(Describe, EffectsAskAQuestionAndNameTheNumbersThatTheyMove) {
    const std::string text = describedInLines("effects");
    EXPECT_EQ(text.find("default"), std::string::npos);
    const Json json = described("effects");
    for (const Effect& effect : effectCatalogue()) {
        EXPECT_NE(text.find(concat({"\n", effect.name, ": ", effect.question})), std::string::npos) << effect.name;
        std::map<std::string, std::size_t> knobs;  // that move a number
        for (const Knob& knob : effect.knobs)
            for (const std::string& path : knob.paths) ++knobs[path];
        for (const auto& [path, count] : knobs)
            EXPECT_EQ(linesWith(text, concat({effect.name, ".", path})), count) << effect.name << " " << path;
    }
    EXPECT_EQ(field(json, "steering_delay.steering.delay")["unit"], "s");
    EXPECT_EQ(field(json, "steering_delay.steering.delay")["meaning"].get<std::string>().find("typically + 0.03 s: "),
              0u);
    EXPECT_EQ(
        field(json, "roll_stiffness_distribution.rear.suspension.anti_roll_bar")["meaning"].get<std::string>().find(
            "typically -/+ 6000 N/m: "),
        0u)
        << "against the front one";
}

TEST(Describe, UnknownNameIsAnsweredWithASuggestionAndTheList) {
    const Result result = runProgram({"describe", "vehcle"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.find("tread: there is no description \"vehcle\", only vehicle, tyre, "), 0u) << result.err;
    EXPECT_NE(result.err.find("; did you mean \"vehicle\"?\n"), std::string::npos) << result.err;
}

TEST(Describe, PathGivesOneFieldAndWhatItContains) {
    const Result entry = runProgram({"describe", "scenario", "phases.3"});
    EXPECT_EQ(entry.status, 0);
    EXPECT_NE(entry.out.find("  phases.0.until.time "), std::string::npos) << entry.out;
    EXPECT_EQ(entry.out.find("  road."), std::string::npos);
    EXPECT_EQ(linesWith(runProgram({"describe", "vehicle", "mass"}).out, "mass"), 1u);
    const Result wrong = runProgram({"describe", "vehicle", "front.suspension.sprin"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_EQ(wrong.err,
              "tread describe: a vehicle has no field \"front.suspension.sprin\"; did you mean "
              "\"front.suspension.spring\"?; `tread describe vehicle` lists all\n");
    EXPECT_EQ(runProgram({"describe", sourceFile("vehicles/compact.yaml"), "mass"}).status, 2);
}

}  // namespace
}  // namespace tread::describe_test
