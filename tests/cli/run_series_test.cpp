// Several runs in one command: numbers that are tuned, series, and the whole catalogue.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/tread_run.h"

namespace tread::run_series_test {
namespace {

using Json = nlohmann::json;

const std::string kCar = kSource + "/vehicles/compact.yaml";

Json resultOf(const Scratch& scratch, const std::string& folder) {
    return Json::parse(contentOf(scratch.path(folder + "/metrics.json")));
}

double metric(const Json& result, const std::string& name) {
    for (const Json& m : result["metrics"]) {
        if (m["name"] == name) return m["value"].is_null() ? std::nan("") : m["value"].get<double>();
    }
    ADD_FAILURE() << "no metric " << name;
    return 0;
}

TEST(RunTuned, AmplitudeIsFoundForTheLateralAccelerationAndSaved) {
    const Scratch scratch;
    const std::string scenario = kSource + "/scenarios/step_steer_to_4.yaml";
    ASSERT_EQ(runProgram({"run", kCar, scenario, "-o", scratch.path("a")}).status, 0);
    const Json found = resultOf(scratch, "a");
    EXPECT_NEAR(metric(found, "steady_ay"), 4, 0.02);
    // The resolved inputs have the amplitude, and nothing that would be looked for again.
    const std::string resolved = contentOf(scratch.path("a/run.yaml"));
    EXPECT_EQ(resolved.find("metric: steady_ay"), std::string::npos);
    const Result other = runProgram({"run", kCar, scenario, "-o", scratch.path("b"), "--set",
                                     "scenario.series.tune.0.target=2", "--set", "mass=1600"});
    ASSERT_EQ(other.status, 0) << other.err;
    EXPECT_NEAR(metric(resultOf(scratch, "b"), "steady_ay"), 2, 0.01);
}

TEST(RunTuned, TargetOutOfReachFailsWithOneSentence) {
    const Scratch scratch;
    const Result result = runProgram({"run", kCar, kSource + "/scenarios/step_steer_to_4.yaml", "-o", scratch.path("a"),
                                      "--set", "scenario.series.tune.0.target=15"});
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.err.find("gives a steady_ay of 15"), std::string::npos) << result.err;
}

TEST(RunSeries, EachRunHasItsFolderAndTheTableItsRow) {
    const Scratch scratch;
    const Result result = runProgram({"run", kCar, kSource + "/scenarios/sine_with_dwell_series.yaml", "-o",
                                      scratch.path("a"), "--set", "scenario.series.vary.factors=[1.5, 3]"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json found = resultOf(scratch, "a");
    ASSERT_EQ(found["runs"].size(), 2u);
    EXPECT_EQ(found["unit"], "rad");
    // 270 deg at least for the last one.
    EXPECT_NEAR(found["runs"][1]["value"].get<double>(), 270 * 3.14159265358979 / 180, 1e-9);
    const Json first = resultOf(scratch, "a/01");
    EXPECT_EQ(first["metrics"], found["runs"][0]["metrics"]);
    EXPECT_NEAR(metric(first, "steering_amplitude"), found["runs"][0]["value"].get<double>() * 180 / 3.14159265358979,
                0.1);
    EXPECT_TRUE(std::filesystem::exists(scratch.path("a/02/report.html")));
    EXPECT_NE(contentOf(scratch.path("a/report.html")).find("href=\"02/report.html\""), std::string::npos);
    const std::string table = contentOf(scratch.path("a/series.csv"));
    EXPECT_EQ(table.find("phases.1.steering.sine_with_dwell.amplitude [rad],passed [-],stable [-],"), 0u);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
}

TEST(RunSeries, WhatItNamesMustExist) {
    const Scratch scratch;
    const auto refused = [&](const std::string& setting) {
        const Result result = runProgram(
            {"run", kCar, kSource + "/scenarios/obstacle_avoidance.yaml", "-o", scratch.path("a"), "--set", setting});
        EXPECT_EQ(result.status, 2) << setting;
        return result.err;
    };
    EXPECT_NE(refused("scenario.series.highest.number=start.sped").find("did you mean \"start.speed\"?"),
              std::string::npos);
    EXPECT_NE(refused("scenario.series.highest.pass=cleen").find("did you mean \"clean\"?"), std::string::npos);
    EXPECT_NE(refused("scenario.series.highest.lowest=20 deg").find("m/s"), std::string::npos);
}

// Every shipped scenario ends, and shows the manoeuvre whose metrics it names.
TEST(RunAll, TheCatalogueRunsAndOnePageLinksIt) {
    const Scratch scratch;
    const Result result =
        runProgram({"run", kCar, "--all", kSource + "/scenarios", "-o", scratch.path("out"), "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const Json all = Json::parse(result.out);
    const std::string page = contentOf(scratch.path("out/index.html"));
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kSource + "/scenarios")) {
        if (entry.path().extension() != ".yaml") continue;
        const std::string name = entry.path().stem().string();
        EXPECT_NE(page.find("href=\"" + name + "/report.html\""), std::string::npos) << name;
        EXPECT_TRUE(std::filesystem::exists(scratch.path("out/" + name + "/report.html"))) << name;
        ++count;
    }
    ASSERT_EQ(all["scenarios"].size(), count);
    for (const Json& scenario : all["scenarios"]) {
        ASSERT_TRUE(scenario.contains("result")) << scenario;
        for (const Json& warning : scenario["result"]["warnings"]) {
            EXPECT_NE(warning.get<std::string>().find("no metrics of"), 0u) << scenario["scenario"] << warning;
        }
        EXPECT_TRUE(scenario["result"]["manoeuvre"] == "" || !scenario["result"]["metrics"].empty() ||
                    scenario["result"].contains("runs"))
            << scenario["scenario"];
    }
}

TEST(RunAll, EachResultHasTheWarnings) {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path("s"));
    scratch.file("s/b.yaml", "title: soon\nphases: [{until: {duration: 0.1}}]\n");
    const Result result = runProgram({"run", kCar, "--all", scratch.path("s"), "-o", scratch.path("out"), "--set",
                                      "aero.drag_area=66 m2", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json warnings = Json::parse(result.out)["scenarios"][0]["result"]["warnings"];
    ASSERT_EQ(warnings.size(), 1u) << warnings;
    EXPECT_EQ("warning: " + warnings[0].get<std::string>() + "\n", result.err);
}

TEST(RunAll, ARunThatFailsDoesNotStopTheOthers) {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path("s"));
    scratch.file("s/a.yaml", "title: never\ntime_limit: 1\nphases: [{until: {speed_above: 100}}]\n");
    scratch.file("s/b.yaml", "title: soon\nphases: [{until: {duration: 0.1}}]\n");
    const Result result = runProgram({"run", kCar, "--all", scratch.path("s"), "-o", scratch.path("out")});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out.find("1 of 2 scenarios driven"), 0u) << result.out;
    EXPECT_NE(result.out.find("failed: the manoeuvre did not end"), std::string::npos) << result.out;
    EXPECT_NE(contentOf(scratch.path("out/index.html")).find("b/report.html"), std::string::npos);
}

TEST(RunAll, AFaultyFileIsNamedAtItsPlaceAndDoesNotStopTheOthers) {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path("s"));
    scratch.file("s/a.yaml", "title: faulty\nphases: [{until: {duraton: 0.1}}]\nspeed: 3\n");
    scratch.file("s/b.yaml", "title: soon\nphases: [{until: {duration: 0.1}}]\n");
    const Result result = runProgram({"run", kCar, "--all", scratch.path("s"), "-o", scratch.path("out")});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out.find("1 of 2 scenarios driven"), 0u) << result.out;
    EXPECT_NE(result.out.find("failed: " + scratch.path("s/a.yaml") + ":2:19: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("(and 1 more fault; `tread check` lists all)\n"), std::string::npos) << result.out;
    const std::string page = contentOf(scratch.path("out/index.html"));
    EXPECT_NE(page.find("a.yaml:2:19: "), std::string::npos);
    EXPECT_NE(page.find("b/report.html"), std::string::npos);

    // What concerns all of them is said once, before anything is driven.
    const Result setting =
        runProgram({"run", kCar, "--all", scratch.path("s"), "-o", scratch.path("none"), "--set", "mas=1500"});
    EXPECT_EQ(setting.status, 2);
    EXPECT_FALSE(std::filesystem::exists(scratch.path("none")));
    EXPECT_EQ(setting.out, "");
}

TEST(RunAll, ALogIsRepeatedByTheScenariosThatRepeatOneAndRefusedByTheOthers) {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path("s"));
    scratch.file("s/plain.yaml", "title: plain\nphases: [{until: {duration: 0.1}}]\n");
    scratch.file("s/repeat.yaml",
                 "title: repeat\nphases: [{steering: {replay: {channel: driver.steering_wheel_angle}}, "
                 "until: {drive_end: true}}]\n");
    ASSERT_EQ(runProgram({"run", kCar, kSource + "/scenarios/step_steer_80.yaml", "-o", scratch.path("drive")}).status,
              0);
    const Result result = runProgram(
        {"run", kCar, "--all", scratch.path("s"), "-o", scratch.path("out"), "--log", scratch.path("drive/log.csv")});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out.find("1 of 2 scenarios driven"), 0u) << result.out;
    EXPECT_NE(result.out.find("found a log of a drive, but nothing that repeats it"), std::string::npos) << result.out;
    EXPECT_TRUE(std::filesystem::exists(scratch.path("out/repeat/report.html")));
}

TEST(RunAll, AFolderWithoutScenariosAndNoScenarioAreRefused) {
    const Scratch scratch;
    const Result empty = runProgram({"run", kCar, "--all", scratch.folder()});
    EXPECT_EQ(empty.status, 2);
    EXPECT_NE(empty.err.find("found no scenario (*.yaml) in the folder"), std::string::npos) << empty.err;
    const Result none = runProgram({"run", kCar});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("expected a file or --all"), std::string::npos) << none.err;
}

TEST(MetricsCommand, LaneChangeNeedsTheScenarioForItsCourse) {
    const Scratch scratch;
    const std::string scenario = kSource + "/scenarios/double_lane_change.yaml";
    ASSERT_EQ(runProgram({"run", kCar, scenario, "-o", scratch.path("a")}).status, 0);
    const std::string log = scratch.path("a/log.csv");
    EXPECT_EQ(runProgram({"metrics", log, "--manoeuvre", "lane_change"}).status, 2);
    const Result with = runProgram({"metrics", log, "--manoeuvre", "lane_change", "--scenario", scenario, "--json"});
    ASSERT_EQ(with.status, 0) << with.err;
    EXPECT_EQ(Json::parse(with.out)["metrics"], resultOf(scratch, "a")["metrics"]);
}

}  // namespace
}  // namespace tread::run_series_test
