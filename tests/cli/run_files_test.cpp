// What `tread run` says of bad vehicle and scenario files.

#include <chrono>

#include "cli/tread_run.h"

namespace tread::run_files_test {
namespace {

// ---- Faults of the vehicle file ------------------------------------------------------------------------------------

TEST_F(TreadRun, MissingNumberOfTheCarIsNamedWithItsPlaceUnitAndMeaning) {
    const std::string text = carText("  track: 1.53 m", "  # track");
    expectCarRefused(text, "unsprung_mass: 38",
                     "front.track: found no value, expected a number in m (distance between the contact points of both "
                     "wheels); add \"track: <number>\"");
}

TEST_F(TreadRun, MisspeltKeyOfTheCarIsAnsweredWithTheRightOne) {
    expectCarRefused(carText("anti_roll_bar: 15 kN/m", "anti_rol_bar: 15 kN/m"), "anti_rol_bar",
                     "front.suspension: found the unknown key \"anti_rol_bar\", expected the name of a field; did you "
                     "mean \"anti_roll_bar\"?");
}

TEST_F(TreadRun, UnitThatDoesNotFitIsRefused) {
    expectCarRefused(carText("mass: 1350 kg", "mass: 1350 m"), "1350 m",
                     "mass: found a length (\"m\"), expected kg; correct the unit");
}

TEST_F(TreadRun, KeyThatIsGivenTwiceIsRefused) {
    const std::string text = carText("mass: 1350 kg  ", "mass: 1350 kg\nmass: 1400 kg  ");
    const std::string first = placeOf(text, "mass: 1350");
    expectCarRefused(text, "mass: 1400",
                     "found the key \"mass\" a second time, expected it once (the first is in line " +
                         first.substr(0, first.find(':')) + "); remove one of the two");
}

TEST_F(TreadRun, NegativeMassIsRefused) {
    expectCarRefused(carText("mass: 1350 kg", "mass: -1350 kg"), "-1350",
                     "mass: found \"-1350 kg\", expected a number in kg above 0; correct the value");
}

TEST_F(TreadRun, NumberThatIsNotFiniteIsRefused) {
    for (const std::string number : {"nan", ".nan", "NaN", "inf", ".inf", "-.inf", "1e999"}) {
        SCOPED_TRACE(number);
        expectCarRefused(
            carText("centre_of_gravity_height: 0.54 m", "centre_of_gravity_height: " + number), number + " ",
            "centre_of_gravity_height: found \"" + number +
                "\", which is not a number, expected m; write a decimal number, alone or followed by a unit");
    }
}

TEST_F(TreadRun, EngineTorqueOutOfOrderIsRefused) {
    expectCarRefused(
        carText("[150, 126], [250, 145]", "[250, 145], [150, 126]"), "150, 126",
        "driveline.engine.full_load.2.x: found x = 150 after 250, expected x to increase strictly; sort the "
        "points and remove repetitions");
}

TEST_F(TreadRun, TyreFileThatDoesNotExistIsRefused) {
    expectCarRefused(carText(kTyre, "tyre: tyres/none.yaml"), "tyres/none.yaml",
                     "front.tyre: found the file name \"tyres/none.yaml\", which " + scratch.path("car.yaml") +
                         " includes, but nothing is there (tried \"" + scratch.path("tyres/none.yaml") +
                         "\"); write a path relative to the including file");
}

TEST_F(TreadRun, CarThatNamesItselfAsTyreIsRefused) {
    expectCarRefused(carText(kTyre, "tyre: car.yaml"), "car.yaml",
                     "front.tyre: found \"car.yaml\", which includes itself through this file; break the cycle");
}

TEST_F(TreadRun, TyreFileThatNamesItselfIsRefused) {
    scratch.file("tyre.yaml", "parameters: tyre.yaml\n");
    car(carText(kTyre, "tyre: tyre.yaml"));
    scenario();
    expectRefused(run(), scratch.path("tyre.yaml") +
                             ":1:13: front.tyre.parameters: found \"tyre.yaml\", expected a map; write \"key: value\" "
                             "lines");
}

TEST_F(TreadRun, OtherCarAsTyreIsRefusedInOneSentence) {
    scratch.file("other.yaml", carText());
    expectCarRefused(carText(kTyre, "tyre: other.yaml"), "other.yaml",
                     "front.tyre: found \"other.yaml\", a file of another kind, expected a file with "
                     "name, side, parameters, lambda or notes; name another file");
}

TEST_F(TreadRun, AliasBombIsRefusedAtOnce) {
    std::string text = "a: &a [x, x, x, x, x, x, x, x, x, x]\n";
    for (char level = 'b'; level <= 'j'; ++level) {
        const std::string inner = std::string("*") + static_cast<char>(level - 1);
        text += std::string(1, level) + ": &" + level + " [";
        for (int i = 0; i < 10; ++i) text += (i > 0 ? ", " : "") + inner;
        text += "]\n";
    }
    const auto begin = std::chrono::steady_clock::now();
    expectCarRefused(text, "*e]\ng", "found more than a million values; write fewer, or fewer aliases");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST_F(TreadRun, EmptyBinaryMissingFilesAndFoldersAreRefused) {
    const std::string road = scenario();
    const std::string file = car("");
    expectRefused(run(), file + ": found nothing in the file, expected \"key: value\" lines; check the path");
    car("# nothing but a remark\n");
    expectRefused(run(), file + ": found nothing in the file, expected \"key: value\" lines; check the path");
    car(std::string("name: \0\1\2", 9));
    expectRefused(run(), file + ":1:7: found a NUL byte, expected UTF-8 text; check that this is not a binary file");
    car("name: \xff\xfe\x80");
    expectRefused(run(), file + ":1:7: found a byte that is not UTF-8; save the file as UTF-8 text");

    const std::string none = scratch.path("none.yaml");
    expectRefused(runProgram({"run", none, road, "-o", out()}),
                  none + ": found no file of this name; correct the path");
    const std::string folder = scratch.path("folder");
    std::filesystem::create_directory(folder);
    const auto message = [&](const std::string& kind) {
        return folder + ": found a folder, expected " + kind +
               "; `tread compare` takes folders of runs, `tread run --all` a folder of scenarios, `tread diagnose "
               "--init` a folder of logs";
    };
    expectRefused(runProgram({"run", folder, road, "-o", out()}), message("a vehicle file"));
    car();
    expectRefused(runProgram({"run", file, folder, "-o", out()}), message("a scenario file"));
}

TEST_F(TreadRun, FaultsOfBothFilesAreToldAtOnce) {
    const std::string text = carText("mass: 1350 kg", "mass: 1350 m");
    car(text);
    scenario(replaced(kScenario, "title", "tilte"));
    expectRefused(
        run(), scratch.path("car.yaml") + ":" + placeOf(text, "1350 m") +
                   ": mass: found a length (\"m\"), expected kg; correct the unit\n" + scratch.path("scenario.yaml") +
                   ":1:1: found the unknown key \"tilte\", expected the name of a field; did you mean \"title\"?");
}

// ---- Faults of the scenario file -----------------------------------------------------------------------------------

TEST_F(TreadRun, MisspeltKeyOfTheScenarioIsAnsweredWithTheRightOne) {
    expectScenarioRefused(
        replaced(kScenario, "speed", "sped"), "sped",
        "start: found the unknown key \"sped\", expected the name of a field; did you mean \"speed\"?");
}

TEST_F(TreadRun, ScenarioWithoutPhasesIsRefused) {
    expectScenarioRefused(
        "title: nothing\n", "title",
        "phases: found no phase, expected at least one that says what the driver does and until when");
}

TEST_F(TreadRun, PhaseWithoutEndIsRefused) {
    expectScenarioRefused(
        replaced(kScenario, "    until: {duration: 0.2 s}\n", ""), "name: straight",
        "phases.0.until.duration: found no condition, expected at least one (duration, time, "
        "speed_below, speed_above, lateral_acceleration_above, lateral_acceleration_below, "
        "sideslip_above, steering_above, distance, x_above, x_below, y_above, y_below, after_steering, laps, when, "
        "yaw_rate_zero or drive_end), or the phase would never end");
}

TEST_F(TreadRun, UnitThatDoesNotFitTheScenarioIsRefused) {
    expectScenarioRefused(replaced(kScenario, "0.2 s", "0.2 m"), "0.2 m",
                          "phases.0.until.duration: found a length (\"m\"), expected s; correct the unit");
}

TEST_F(TreadRun, UnknownManoeuvreIsRefusedBeforeTheCarDrives) {
    expectScenarioRefused("manoeuvre: step_ster\n" + kScenario, "step_ster",
                          "manoeuvre: found the unknown manoeuvre \"step_ster\", expected " + kManoeuvres +
                              "; did you mean \"step_steer\"?");
}

TEST_F(TreadRun, ChannelThatDoesNotExistIsRefusedBeforeTheCarDrives) {
    const std::string text = kScenario + "log: {channels: [chassis.*, chasis.vx, wheel.*.lod]}\n";
    car();
    scenario(text);
    const std::string file = scratch.path("scenario.yaml") + ":";
    expectRefused(run(), file + placeOf(text, "chasis.vx") +
                             ": log.channels.1: found \"chasis.vx\", which matches no channel, expected a name or a "
                             "pattern with *; did you mean \"chassis.vx\"? `tread describe log` lists all channels\n" +
                             file + placeOf(text, "wheel.*.lod") +
                             ": log.channels.2: found \"wheel.*.lod\", which matches no channel, expected a name or a "
                             "pattern with *; `tread describe log` lists all channels");
}

TEST_F(TreadRun, CarInPlaceOfTheScenarioIsRefusedInOneSentence) {
    const std::string file = car();
    expectRefused(runProgram({"run", file, file, "-o", out()}),
                  file +
                      ": found a vehicle file, expected a scenario file; `tread run` takes it first, `tread describe` "
                      "shows its data sheet");
}

TEST_F(TreadRun, FaultsOfFilesAndSettingsAreToldTogether) {
    const std::string text = carText("mass: 1350 kg", "mass: 1350 m");
    car(text);
    scenario(replaced(kScenario, "0.2 s", "0.2 m") + "log: {channels: [chasis.vx]}\n");
    const Result result = run({"--set", "scenario.start.speed=fast", "--set", "wheelbas=3"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 5) << result.err;
    for (const std::string part : {": mass: ", ": phases.0.until.duration: ", ": log.channels.0: ",
                                   "--set: scenario.start.speed: ", "--set: wheelbas: "})
        EXPECT_NE(result.err.find(part), std::string::npos) << part << "\n" << result.err;
}

}  // namespace
}  // namespace tread::run_files_test
