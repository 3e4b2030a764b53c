// `tread run` with manoeuvres that the car cannot do and cars that break down.

#include <cmath>

#include "cli/tread_run.h"
#include "log/csv.h"

namespace tread::run_failure_test {
namespace {

const std::string kNoSuspect = "; none of the numbers of car and scenario is implausible, so no field is suspected";

TEST_F(TreadRun, SpeedThatIsNeverReachedFailsAndNamesThePhase) {
    car();
    scenario(R"(time_limit: 1.5 s
start: {speed: 80 km/h}
phases:
  - name: run up
    throttle: {constant: {value: 1}}
    until: {speed_above: 300 km/h}
)");
    const Result result = run();
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.substr(0, result.err.find("; the car moves at ")),
              "tread run: the manoeuvre did not end within 1.5 s: phase \"run up\" waits for a speed above 83.33 m/s");
    EXPECT_TRUE(result.err.ends_with(
        " of lateral acceleration; change the scenario, or raise time_limit; the rows so far are in '" +
        out("log.incomplete.csv") + "'\n"))
        << result.err;
    EXPECT_EQ(results(), kFailedResults);
    EXPECT_NEAR(readLog(out("log.incomplete.csv")).channels[0].values.back(), 1.5, 0.011);
}

TEST_F(TreadRun, StartSpeedThatTheCarCannotHoldFails) {
    car();
    scenario(replaced(kScenario, "80 km/h", "250 km/h"));
    const Result result = run();
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    expectStart(
        result.err,
        "tread run: the car cannot hold the 69.4 m/s at which the scenario starts: that would take a throttle of ");
    EXPECT_TRUE(result.err.ends_with(", and only 0 to 1 is possible; lower start.speed or give the car more power\n"))
        << result.err;
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, StandingOnASlopeWithoutBrakesFails) {
    car();
    scenario("road: {grade: 20 %}\nphases: [{until: {duration: 1}}]\n");
    const Result result = run();
    EXPECT_EQ(result.status, 3);
    expectStart(result.err, "tread run: the car finds no equilibrium to start from: ");
    EXPECT_TRUE(
        result.err.ends_with(" m/s2 are left after settling (does it stand on a slope with its brakes off, or on "
                             "ice?)" +
                             kNoSuspect + "\n"))
        << result.err;
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, CarThatRollsOverFailsAndKeepsItsLog) {
    car();
    scenario(R"(start: {speed: 80 km/h}
phases:
  - {steering: {ramp: {to: 400 deg, rate: 1000 deg/s}}, until: {duration: 10 s}}
)");
    const Result result = run({"--set", "centre_of_gravity_height=1.6"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    expectStart(result.err, "tread run: the car rolled over at t = ");
    EXPECT_NE(result.err.find(" s: chassis.roll is 8"), std::string::npos) << result.err;
    EXPECT_TRUE(
        result.err.ends_with("; the rows so far are in '" + out("log.incomplete.csv") + "'" + kNoSuspect + "\n"))
        << result.err;
    EXPECT_EQ(results(), kFailedResults);
}

TEST_F(TreadRun, CarThatIsFlungAwayFailsAndKeepsTheLogSoFar) {
    // A gust that comes only after the start, and that is far too strong.
    car();
    scenario();
    const Result result = run({"--set", "scenario.wind.gust.shape=step", "--set", "scenario.wind.gust.speed=-40000",
                               "--set", "scenario.wind.gust.time=0.05", "--set", "scenario.log.rate=1000"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    const std::string suspect =
        "--set: scenario.wind.gust.speed: found -40000 m/s, plausible values are -40 to 40 m/s; check value and unit\n";
    expectStart(result.err, "warning: " + suspect + "tread run: the car left the bounds of the simulation at t = 0.0");
    EXPECT_NE(result.err.find(" s: its speed (chassis.vx, vy, vz) is "), std::string::npos) << result.err;
    EXPECT_TRUE(result.err.ends_with(", more than 200 m/s; the rows so far are in '" + out("log.incomplete.csv") +
                                     "'; suspect: " + suspect))
        << result.err;
    EXPECT_EQ(results(), kFailedResults);
    for (const Channel& channel : readLog(out("log.incomplete.csv")).channels) {
        EXPECT_GT(channel.values.size(), 10U);
        for (const double value : channel.values) EXPECT_TRUE(std::isfinite(value)) << channel.name;
    }
}

TEST_F(TreadRun, AFailedRunOfASeriesNamesSuspects) {
    car(carText("roll: 480 kg m2", "roll: 1e-6"));
    scenario(kScenario + "series: {vary: {number: start.speed, values: [40 km/h, 60 km/h]}}\n");
    const Result result = run();
    EXPECT_NE(contentOf(out("metrics.json")).find("; suspect: "), std::string::npos) << result.out << result.err;
    EXPECT_NE(contentOf(out("metrics.json")).find(": inertia.roll: found 1e-6 kg m2"), std::string::npos);
}

TEST_F(TreadRun, CarThatBreaksDownWhileItSettlesFailsAndNamesThreeSuspects) {
    const std::string text = replaced(carText("roll: 480 kg m2", "roll: 1e-6"), "drag_area: 0.66 m2", "drag_area: 66");
    car(text);
    scenario("road: {friction: 80}\n" + kScenario);
    const Result result = run({"--set", "steering.ratio=0.06"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("tread run: the simulation broke down before the start, while the car settled on its "
                              "wheels: its acceleration is "),
              std::string::npos)
        << result.err;
    const std::string file = scratch.path("car.yaml") + ":";
    const std::string roll = file + placeOf(text, "1e-6") + ": inertia.roll: found 1e-6 kg m2, plausible values are ";
    const std::size_t suspects = result.err.find("; suspects: " + roll);
    ASSERT_NE(suspects, std::string::npos) << result.err;
    EXPECT_NE(result.err.find("; --set: steering.ratio: ", suspects), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("; " + file + placeOf(text, "66 ") + ": aero.drag_area: ", suspects), std::string::npos)
        << result.err;
    EXPECT_TRUE(result.err.ends_with("; and 1 more\n")) << result.err;
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, FailureDoesNotPassOffAnEarlierLogAsItsOwn) {
    car();
    scenario();
    std::filesystem::create_directories(out());
    for (const char* name : {"log.csv", "log.incomplete.csv", "report.html", "metrics.json"}) {
        std::ofstream(out(name)) << "of an earlier run\n";
    }
    const Result result = run({"--set", "scenario.start.speed=250 km/h"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.err.find("log so far"), std::string::npos) << result.err;
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, BadInputLeavesEarlierResultsAlone) {
    car();
    scenario();
    std::filesystem::create_directories(out());
    std::ofstream(out("log.csv")) << "of an earlier run\n";
    EXPECT_EQ(run({"--set", "mass=-1"}).status, 2);
    EXPECT_EQ(contentOf(out("log.csv")), "of an earlier run\n");
}

}  // namespace
}  // namespace tread::run_failure_test
