// `tread run --set`: what it reaches, and what it says of bad paths and values.

#include <nlohmann/json.hpp>

#include "cli/tread_run.h"
#include "log/csv.h"

namespace tread::run_settings_test {
namespace {

const std::string kHeavy =
    "--set: mass: found \"heavy\", which is not a number, expected kg; write a decimal number, alone or followed by a "
    "unit";
const std::string kLongStep =
    "--set: scenario.step: found \"1\", expected a number in s from 0.00001 to 0.05; correct the value";

TEST_F(TreadRun, SettingsReachCarAndScenario) {
    car();
    scenario();
    const Result result =
        run({"--set", "mass=1400", "--set", "front.suspension.spring=25 kN/m", "--set", "scenario.step=0.016666",
             "--set", "scenario.phases.0.until.duration=0.1 s", "--set", "scenario.log.channels=[chassis.vx]"});
    EXPECT_EQ(result.status, 0) << result.err;
    const std::string resolved = contentOf(out("run.yaml"));
    for (const char* line : {"  mass: 1400 ", "      spring: 25000 ", "  step: 0.016666 ", "        duration: 0.1 "}) {
        EXPECT_NE(resolved.find(line), std::string::npos) << line;
    }
    const Log log = readLog(out("log.csv"));
    EXPECT_EQ(log.channels.size(), 2u);
    EXPECT_EQ(log.channels[0].values[1], 0.016666);
    EXPECT_NEAR(log.channels[0].values.back(), 0.1, 0.016666);
}

// A title that states a value says what was changed of it, wherever it is shown, and so does the name of the car.
TEST_F(TreadRun, TitleAndCarSayWhatSettingsHaveChanged) {
    car();
    scenario("title: Drive at 80 km/h\nstart: {speed: 80 km/h}\nphases: [{until: {duration: 0.1 s}}]\n");
    const Result result = run({"--set", "scenario.start.speed=80 mph", "--set", "mass=1400", "--set",
                               "scenario.phases.0.until.duration=100 ms", "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string change = "start.speed 80 mph (was 80 km/h)";
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["scenario"], "Drive at 80 km/h [changed: " + change + "]") << "the same duration is no change";
    EXPECT_NE(json["answer"].get<std::string>().find(change), std::string::npos);
    EXPECT_NE(json["vehicle"].get<std::string>().find(" [changed: mass 1400 kg (was "), std::string::npos);
    const std::string page = contentOf(out("report.html"));
    EXPECT_NE(page.find("<h1>Drive at 80 km/h</h1>\n<p class=\"changed\">changed: " + change + "</p>"),
              std::string::npos);
    EXPECT_NE(contentOf(out("run.yaml")).find(change), std::string::npos) << "also when the run is repeated";
    EXPECT_EQ(run().out.find("changed"), std::string::npos);
}

TEST_F(TreadRun, UnknownPathIsAnsweredWithTheRightOne) {
    car();
    scenario();
    const auto expectAnswer = [&](const std::string& path, const std::string& answer) {
        expectRefused(run({"--set", path + "=1"}), "--set: " + path + ": found the unknown path \"" + path +
                                                       "\", expected the path of a field; " + answer);
    };
    const std::string of_the_car = "`tread describe vehicle` lists all paths";
    const std::string of_the_scenario = "`tread describe scenario` lists all paths after \"scenario.\"";
    expectAnswer("front.suspension.sprng", "did you mean \"front.suspension.spring\"? " + of_the_car);
    expectAnswer("spring", "did you mean front.suspension.spring or rear.suspension.spring? " + of_the_car);
    expectAnswer("quux", of_the_car);
    expectAnswer("scenario.stp", "did you mean \"scenario.step\"? " + of_the_scenario);
    expectAnswer("scenario.x", of_the_scenario);
    expectAnswer("step", "did you mean scenario.step? " + of_the_scenario);
}

TEST_F(TreadRun, TheScenarioChangesTheCarAndTheCommandLineHasTheLastWord) {
    car();
    const std::string settings = "car_settings: [mass=1500, centre_of_gravity_height=0.6 m]\n";
    const std::string path = scratch.file("scenario.yaml", kScenario + settings);
    ASSERT_EQ(run().status, 0);
    EXPECT_NE(contentOf(scratch.path("out/run.yaml")).find("mass: 1500"), std::string::npos);
    ASSERT_EQ(run({"--set", "mass=1400"}).status, 0);
    EXPECT_NE(contentOf(scratch.path("out/run.yaml")).find("mass: 1400"), std::string::npos);
    EXPECT_NE(contentOf(scratch.path("out/run.yaml")).find("centre_of_gravity_height: 0.6"), std::string::npos);
    scratch.file("scenario.yaml", kScenario + "car_settings: [mas=1500]\n");
    EXPECT_EQ(run().err, path +
                             ": car_settings: mas: found the unknown path \"mas\", expected the path of a field; did "
                             "you mean \"mass\"? `tread describe vehicle` lists all paths\n");
}

TEST_F(TreadRun, BadValueOfASettingIsRefused) {
    car();
    scenario();
    expectRefused(run({"--set", "mass=1350 m"}), "--set: mass: found a length (\"m\"), expected kg; correct the unit");
    expectRefused(run({"--set", "mass=heavy"}), kHeavy);
    expectRefused(run({"--set", "mass"}),
                  "--set: found \"mass\", expected path=value; `tread describe vehicle` lists all paths");
    expectRefused(run({"--set", "front_axle_distance=3"}),
                  "--set: front_axle_distance: the centre of gravity must lie between the axles (front_axle_distance < "
                  "wheelbase)");
    expectRefused(run({"--set", "scenario.step=1"}), kLongStep);
    expectRefused(run({"--set", "scenario.manoeuvre=turn"}),
                  "--set: scenario.manoeuvre: found the unknown manoeuvre \"turn\", expected " + kManoeuvres);
    expectRefused(run({"--set", "scenario.log.channels=[chassis.vxx]"}),
                  "--set: scenario.log.channels.0: found \"chassis.vxx\", which matches no channel, expected a name or "
                  "a pattern with *; did you mean \"chassis.vx\"? `tread describe log` lists all channels");
}

TEST_F(TreadRun, AllBadSettingsAreToldAtOnce) {
    car();
    scenario();
    expectRefused(run({"--set", "mass=heavy", "--set", "scenario.step=1"}), kHeavy + "\n" + kLongStep);
}

TEST_F(TreadRun, ImplausibleSettingsAreWarnedOfOnceAndAreFaultsWithStrict) {
    car();
    scenario();
    const std::string height =
        "--set: centre_of_gravity_height: found 550 m, plausible values are 0.02 to 3 m; did you mean "
        "\"550 mm\"?\n";
    const std::string speed =
        "--set: scenario.start.speed: found 80 m/s, plausible values are 0 to 70 m/s; did you mean "
        "\"80 km/h\"?\n";
    const Result strict = run({"--set", "height=550", "--set", "scenario.start.speed=80", "--strict"});
    EXPECT_EQ(strict.status, 2);
    EXPECT_EQ(strict.err, height + speed);

    // A car setting of the scenario, and the car once for two scenarios.
    std::filesystem::create_directory(scratch.path("all"));
    scratch.file("all/a.yaml", kScenario);
    const std::string second = kScenario + "car_settings: [steering.play=7]\n";
    const std::string file = scratch.file("all/b.yaml", second);
    const std::string text = carText("mass: 1350 kg", "mass: 2975 lb").append("  air_density: 12\n");
    const Result all = runProgram({"run", car(text), "--all", scratch.path("all"), "-o", out()});
    EXPECT_EQ(all.err,
              "warning: " + scratch.path("car.yaml") + ":" + placeOf(text, "12\n") +
                  ": aero.air_density: found 12 kg/m3, plausible values are 0.5 to 1.6 kg/m3; check value and unit\n" +
                  "warning: " + file + ":" + placeOf(second, "steering.play=7") +
                  ": steering.play: found 7 rad, plausible values are 0 to 0.7 rad; did you mean \"7 deg\"?\n")
        << all.out;
}

TEST_F(TreadRun, SettingMayStandBeforeTheFiles) {
    const Result result = runProgram({"run", "--set", "mass=1400", car(), scenario(), "-o", out()});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(contentOf(out("run.yaml")).find("  mass: 1400 "), std::string::npos);
}

}  // namespace
}  // namespace tread::run_settings_test
