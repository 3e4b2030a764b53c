// Series of runs, with a car that is a formula.

#include "series/series.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/yaml/read.h"
#include "metrics/metrics.h"
#include "run/simulate.h"
#include "shared/scratch.h"

namespace tread::series_test {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

Scenario scenarioOf(const std::string& series) {
    return readYamlText<Scenario>(
        "start: {speed: 20}\nphases: [{steering: {ramp: {to: 10 deg, rate: 1}}, until: {duration: 1}}]\nseries: " +
            series,
        "scenario.yaml");
}

double angleOf(const Scenario& scenario) {
    return std::get<Ramp<Angle>>(scenario.phases[0].steering).to;
}

constexpr const char* kNumber = "phases.0.steering.ramp.to";

TEST(Tune, FindsTheNumberOfACurvedAnswerInFewRuns) {
    int runs = 0;
    const Measure car = [&](const Scenario& s) {
        ++runs;
        return std::vector<Metric>{{"steady_ay", 8 * std::tanh(angleOf(s) / 1.2), "m/s2", ""}};
    };
    for (const double target : {1.0, 4.0, 7.5}) {
        runs = 0;
        const Scenario found = tuned(scenarioOf("{tune: [{number: " + std::string(kNumber) +
                                                ", metric: steady_ay, target: " + std::to_string(target) +
                                                ", lowest: 1 deg, highest: 270 deg}]}"),
                                     car);
        EXPECT_NEAR(angleOf(found), 1.2 * std::atanh(target / 8), 0.06 * angleOf(found)) << "0.5 % of the target";
        EXPECT_NEAR(8 * std::tanh(angleOf(found) / 1.2), target, 0.005 * target);
        EXPECT_LE(runs, 12) << target;
    }
}

TEST(Tune, FindsItBetweenItsLimitsWhenTheAnswerJumps) {
    const Measure car = [](const Scenario& s) {
        const double x = angleOf(s);
        return std::vector<Metric>{{"m", x < 0.8 ? 0.1 * x : 2 + x, "-", ""}};
    };
    const Scenario found = tuned(
        scenarioOf("{tune: [{number: " + std::string(kNumber) + ", metric: m, target: 3, lowest: 0, highest: 2}]}"),
        car);
    EXPECT_NEAR(angleOf(found), 1, 0.02);
}

TEST(Tune, TargetOutOfReachIsToldWithTheLastTry) {
    const Measure car = [](const Scenario& s) {
        return std::vector<Metric>{{"steady_ay", 8 * std::tanh(angleOf(s)), "m/s2", ""}};
    };
    try {
        tuned(scenarioOf("{tune: [{number: " + std::string(kNumber) +
                         ", metric: steady_ay, target: 9, lowest: 1 deg, highest: 270 deg}]}"),
              car);
        FAIL() << "no error";
    } catch (const SeriesError& error) {
        EXPECT_NE(std::string(error.what())
                      .find("no phases.0.steering.ramp.to between 1 deg and 270 deg gives a "
                            "steady_ay of 9"),
                  std::string::npos)
            << error.what();
    }
}

TEST(Vary, RunsEachValueInItsUnit) {
    std::vector<double> driven;
    const Measure run = [&](const Scenario& s) {
        EXPECT_TRUE(s.series.empty()) << "a run of a series is a run";
        driven.push_back(angleOf(s) / kDegree);
        return std::vector<Metric>{{"stable", angleOf(s) < 0.5 ? 1.0 : 0.0, "-", ""}};
    };
    const SeriesResult found = series(
        scenarioOf("{vary: {number: " + std::string(kNumber) + ", values: [10 deg, 20 deg, 0.6], pass: stable}}"), run,
        run);
    ASSERT_EQ(driven.size(), 3u);
    EXPECT_NEAR(driven[0], 10, 1e-9);
    EXPECT_NEAR(driven[1], 20, 1e-9);
    EXPECT_EQ(found.unit, "rad");
    EXPECT_TRUE(found.runs[1].passed);
    EXPECT_FALSE(found.runs[2].passed);
    EXPECT_EQ(found.runs[2].value, 0.6);
}

TEST(Vary, FactorsMultiplyTheMetricOfAnotherScenarioWithinLimits) {
    const Scratch scratch;
    const std::string other = scratch.file("other.yaml", "title: other\nphases: [{until: {duration: 1}}]\n");
    const Measure measure = [](const Scenario& s) {
        EXPECT_EQ(s.title, "other");
        return std::vector<Metric>{{"angle", 50, "deg", ""}};
    };
    std::vector<double> driven;
    const Measure run = [&](const Scenario& s) {
        driven.push_back(angleOf(s) / kDegree);
        return std::vector<Metric>{};
    };
    series(scenarioOf("{vary: {number: " + std::string(kNumber) + ", factors: [1, 2, 3], of_scenario: " + other +
                      ", of_metric: angle, least_last: 270 deg, largest: 300 deg}}"),
           measure, run);
    ASSERT_EQ(driven.size(), 3u);
    EXPECT_NEAR(driven[0], 50, 1e-9);
    EXPECT_NEAR(driven[1], 100, 1e-9);
    EXPECT_NEAR(driven[2], 270, 1e-9);
    driven.clear();
    series(scenarioOf("{vary: {number: " + std::string(kNumber) + ", factors: [5, 6, 7], of_scenario: " + other +
                      ", of_metric: angle, largest: 300 deg}}"),
           measure, run);
    EXPECT_EQ(driven.size(), 2u) << "two values at the limit are one run";
}

TEST(Vary, ARunThatFailsIsKeptWithItsReason) {
    const Measure run = [](const Scenario& s) -> std::vector<Metric> {
        if (angleOf(s) > 0.3) throw SimulationError("the car rolled over", 1);
        if (angleOf(s) > 0.2) throw MetricError("no step");
        return {};
    };
    const SeriesResult found =
        series(scenarioOf("{vary: {number: " + std::string(kNumber) + ", values: [0.1, 0.25, 0.4]}}"), run, run);
    ASSERT_EQ(found.runs.size(), 3u);
    EXPECT_EQ(found.runs[0].failure, "");
    EXPECT_EQ(found.runs[1].failure, "no step");
    EXPECT_EQ(found.runs[2].failure, "the car rolled over");
    EXPECT_FALSE(found.runs[2].passed);
}

TEST(Highest, BisectionFindsTheSpeedWithinTheResolution) {
    const Measure run = [](const Scenario& s) {
        return std::vector<Metric>{{"clean", s.start.speed <= 17.3 ? 1.0 : 0.0, "-", ""}};
    };
    const auto search = [&](const std::string& limits) {
        return series(scenarioOf("{highest: {number: start.speed, " + limits + ", resolution: 0.5 km/h, pass: clean}}"),
                      run, run);
    };
    const SeriesResult found = search("lowest: 36 km/h, highest: 90 km/h");
    EXPECT_LE(found.highest, 17.3);
    EXPECT_GT(found.highest, 17.3 - 0.5 / 3.6);
    EXPECT_LE(found.runs.size(), 10u);
    EXPECT_TRUE(std::isnan(search("lowest: 20, highest: 30").highest)) << "not even the lowest";
    EXPECT_EQ(search("lowest: 5, highest: 15").highest, 15) << "all pass";
    EXPECT_EQ(search("lowest: 5, highest: 15").runs.size(), 2u);
}

TEST(SeriesFaults, NameWhatTheScenarioDoesNotHave) {
    EXPECT_EQ(faultOf(scenarioOf("{highest: {number: start.speed, lowest: 1, highest: 2, resolution: 1, pass: x}}")),
              "");
    EXPECT_NE(faultOf(scenarioOf("{highest: {number: start.sped, lowest: 1, highest: 2, resolution: 1, pass: x}}"))
                  .find("did you mean \"start.speed\"?"),
              std::string::npos);
    EXPECT_NE(faultOf(scenarioOf("{vary: {number: start.speed, values: [10 deg]}}")).find("m/s"), std::string::npos);
}

}  // namespace
}  // namespace tread::series_test
