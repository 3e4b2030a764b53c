// Verdicts on a run: conditions in the scenario and in a file of their own, exit status, page, JSON and JUnit.

#include <nlohmann/json.hpp>

#include "cli/tread_run.h"

namespace tread::accept_test {
namespace {

using Json = nlohmann::json;

const std::string kStop =
    "title: Stop\n"
    "manoeuvre: straight_braking\n"
    "start: {speed: 50 km/h}\n"
    "phases:\n"
    "  - {throttle: {constant: {value: 0}}, until: {duration: 0.2}}\n"
    "  - {throttle: {constant: {value: 0}}, brake: {ramp: {to: 0.8, rate: 8}}, until: {speed_below: 0.01, "
    "duration: 20}}\n";

struct Accept : TreadRun {
    Accept() { car(); }
    Json resultJson() const { return Json::parse(contentOf(out("metrics.json"))); }
};

TEST_F(Accept, ConditionsThatAreMetHaveStatusZeroAndAreSaid) {
    scenario(kStop + "accept:\n  stopping_distance: \"5 .. 40 m\"\n");
    const Result result = run({"--junit", scratch.path("j.xml")});
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_NE(firstLine(result.out).find("; accepted: 1 condition met"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find(", required 5 .. 40 m: met, "), std::string::npos) << result.out;
    const Json json = resultJson();
    ASSERT_EQ(json["verdicts"].size(), 1u);
    EXPECT_EQ(json["verdicts"][0]["met"], true);
    EXPECT_EQ(json["verdicts"][0]["metric"], "stopping_distance");
    EXPECT_NE(contentOf(out("report.html")).find("verdict good\">✓ accepted"), std::string::npos);
    EXPECT_NE(contentOf(scratch.path("j.xml")).find("tests=\"2\" failures=\"0\" errors=\"0\""), std::string::npos);
    // What was resolved repeats the verdict.
    EXPECT_NE(contentOf(out("run.yaml")).find("stopping_distance: \"5 .. 40 m\""), std::string::npos);
}

TEST_F(Accept, AMissHasStatusOneInWordsColourJsonAndJUnit) {
    scenario(kStop + "accept: {stopping_distance: \"< 5 m\", initial_speed: \"50 km/h +- 5 %\"}\n");
    const Result result = run({"--junit", scratch.path("j.xml"), "--json"});
    EXPECT_EQ(result.status, 1) << result.out << result.err;
    EXPECT_EQ(result.err, "");
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json, resultJson());
    EXPECT_EQ(json["verdicts"][0]["met"], false);
    EXPECT_EQ(json["verdicts"][1]["met"], true);
    EXPECT_NE(json["answer"].get<std::string>().find("not accepted: 1 of 2 conditions missed"), std::string::npos);
    const std::string page = contentOf(out("report.html"));
    EXPECT_NE(page.find("verdict bad\">✗ not accepted"), std::string::npos);
    EXPECT_NE(page.find("class=\"alarm\">missed"), std::string::npos);
    EXPECT_NE(page.find("class=\"good-news\">met"), std::string::npos);
    const std::string junit = contentOf(scratch.path("j.xml"));
    EXPECT_NE(junit.find("tests=\"3\" failures=\"1\" errors=\"0\""), std::string::npos) << junit;
    EXPECT_NE(junit.find("name=\"stopping_distance &lt; 5 m\"><failure message=\"stopping_distance: "),
              std::string::npos)
        << junit;
}

TEST_F(Accept, AFileReplacesTheConditionOfTheSameMetric) {
    scenario(kStop + "accept: {stopping_distance: \"< 5 m\"}\n");
    const std::string file = scratch.file("accept.yaml", "accept: {stopping_distance: \"< 60 m\"}\n");
    const Result result = run({"--accept", file});
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_NE(result.out.find("required < 60 m: met"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("< 5 m"), std::string::npos) << result.out;
}

TEST_F(Accept, AMetricThatCouldNotBeComputedIsAMissAndSaysSo) {
    scenario(replaced(kStop, "until: {speed_below: 0.01, duration: 20}", "until: {duration: 0.5}") +
             "accept: {stopping_distance: \"< 500 m\"}\n");
    const Result result = run();
    EXPECT_EQ(result.status, 1) << result.out << result.err;
    EXPECT_NE(result.out.find("stopping_distance: could not be computed, required < 500 m: missed"), std::string::npos)
        << result.out;
}

TEST_F(Accept, UnknownMetricsAndWrongUnitsAreRefusedAtTheirPlace) {
    const std::string start = kStop + "accept:\n  ";
    const auto expectRefusal = [&](const std::string& line, const std::string& at, const std::string& fault) {
        const std::string text = start + line + "\n";
        const std::string file = scenario(text);
        const std::string place = file + ":" + placeOf(text, at) + ": accept.";
        const Result drive = run(), check = runProgram({"check", file});
        EXPECT_EQ(drive.status, 2);
        EXPECT_EQ(check.status, 2);
        EXPECT_EQ(drive.err.find(place), 0u) << drive.err << place;
        EXPECT_NE(drive.err.find(fault), std::string::npos) << drive.err;
        EXPECT_NE(check.out.find(place), std::string::npos) << check.out;
    };
    expectRefusal("stoping_distance: \"< 40 m\"", "\"< 40 m\"", "did you mean \"stopping_distance\"?");
    expectRefusal("stopping_distance: \"< 40 kg\"", "\"< 40 kg\"", "found a mass (\"kg\"), expected m");
    expectRefusal("stopping_distance: 40 m", "40 m\n", "expected a condition such as");
    EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(Accept, TheFileIsCheckedAsWell) {
    scenario(kStop);
    const std::string text = "accept:\n  stoping_distance: \"< 40 m\"\n";
    const std::string file = scratch.file("accept.yaml", text);
    const std::string place = file + ":2:21: accept.stoping_distance: ";
    EXPECT_EQ(run({"--accept", file}).err.find(place), 0u);
    const Result check = runProgram({"check", file});
    EXPECT_EQ(check.status, 2);
    EXPECT_NE(check.out.find(place), std::string::npos) << check.out;
    const Result fine = runProgram({"check", scratch.file("b.yaml", "accept: {stopping_distance: \"< 40 m\"}\n")});
    EXPECT_EQ(fine.status, 0) << fine.out;
    EXPECT_NE(fine.out.find("b.yaml: accept, fine"), std::string::npos) << fine.out;
    const Result own = runProgram({"check", scratch.file("c.yaml", "accept:\n  jerk_of_the_neck: \"< 4\"\n")});
    EXPECT_EQ(own.status, 0) << own.out << own.err;
    EXPECT_NE(own.err.find("c.yaml: note: line 2: no manoeuvre has a metric \"jerk_of_the_neck\"; a scenario or a file "
                           "given with --metrics must define it"),
              std::string::npos)
        << own.err;
}

TEST_F(Accept, OfAFolderEachScenarioTakesWhatItHas) {
    std::filesystem::create_directory(scratch.path("s"));
    scratch.file("s/stop.yaml", kStop);
    scratch.file("s/straight.yaml", kScenario);
    const std::string file = scratch.file("accept.yaml",
                                          "accept: {stopping_distance: \"< 60 m\"}\n"
                                          "accept_of:\n  - {scenario: stop, accept: {mfdd: \"> 1000 m/s2\"}}\n");
    const auto all = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", scratch.path("car.yaml"), "--all", scratch.path("s"), "-o", out()};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    };
    const Result result = all({"--accept", file, "--junit", scratch.path("j.xml")});
    EXPECT_EQ(result.status, 1) << result.out << result.err;
    EXPECT_NE(firstLine(result.out).find("not accepted: 1 of 2 conditions missed"), std::string::npos) << result.out;
    EXPECT_NE(
        contentOf(out("index.html")).find("class=\"alarm\">✗ not accepted, missed: Deceleration, mean fully developed"),
        std::string::npos);
    EXPECT_NE(contentOf(scratch.path("j.xml")).find("tests=\"4\" failures=\"1\" errors=\"0\""), std::string::npos);

    const std::string unused = scratch.file("unused.yaml", "accept: {cones_hit: \"= 0\"}\n");
    const Result refused = all({"--accept", unused});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err.find(unused + ":1:21: accept.cones_hit: "), 0u) << refused.err;
}

TEST_F(Accept, MetricsOfALogAreJudgedToo) {
    scenario(kStop);
    ASSERT_EQ(run().status, 0);
    const std::string file = scratch.file("accept.yaml", "accept: {stopping_distance: \"< 5 m\"}\n");
    const Result result = runProgram({"metrics", out("log.csv"), "--accept", file});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(result.out.find("required < 5 m: missed"), std::string::npos) << result.out;
}

// In a search for the highest value that passes, runs must fail; the condition is on what the search finds.
TEST_F(Accept, ASearchIsJudgedByWhatItFinds) {
    const std::string search = kSource + "/scenarios/obstacle_avoidance.yaml";
    const auto judged = [&](const std::string& condition) {
        return runProgram({"run", kSource + "/vehicles/compact.yaml", search, "-o", out(), "--accept",
                           scratch.file("accept.yaml", "accept: {" + condition + "}\n")});
    };
    EXPECT_EQ(judged("highest_start.speed: '>= 50 km/h'").status, 0);
    EXPECT_EQ(judged("highest_start.speed: '>= 70 km/h'").status, 1);
    const Result other = judged("cones_hit: '= 0'");
    EXPECT_EQ(other.status, 2);
    EXPECT_NE(other.err.find("which is not a metric of a search, which has \"highest_start.speed\" alone"),
              std::string::npos)
        << other.err;
}

// In a series, every run is judged.
TEST_F(Accept, EveryRunOfASeriesIsJudged) {
    scenario(kStop + "series: {vary: {number: start.speed, values: [40 km/h, 60 km/h]}}\n" +
             "accept: {initial_speed: \"< 50 km/h\"}\n");
    const Result result = run();
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(result.out.find("Verdict: run 01, initial_speed: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("not accepted: 1 of 2 conditions missed"), std::string::npos) << result.out;
    EXPECT_NE(contentOf(out("02/report.html")).find("verdict bad"), std::string::npos);
    EXPECT_NE(contentOf(out("01/report.html")).find("verdict good"), std::string::npos);
}

// The limits of the standards that the shipped scenarios carry.
TEST_F(Accept, ShippedLimits) {
    const std::string compact = kSource + "/vehicles/compact.yaml";
    const std::string lanes = kSource + "/scenarios/double_lane_change.yaml";
    const Result clean = runProgram({"run", compact, lanes, "-o", out()});
    EXPECT_EQ(clean.status, 0) << clean.out << clean.err;
    EXPECT_NE(clean.out.find("cones_hit: 0, required = 0: met"), std::string::npos) << clean.out;
    const Result slippery = runProgram({"run", compact, lanes, "-o", out(), "--set", "scenario.start.speed=110 km/h"});
    EXPECT_EQ(slippery.status, 1) << slippery.out << slippery.err;
}

}  // namespace
}  // namespace tread::accept_test
