// `tread diagnose` and `tread identify` before they compute anything: what they refuse, and what they say of the data.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/killed.h"
#include "cli/program.h"
#include "log/csv.h"
#include "places/places.h"

namespace tread::diagnose_test {
namespace {

// A gentle slalom at 20 m/s that keeps to kinematics.
Log slalom(double seconds = 6) {
    Log log{{{"time", "s", {}},
             {"driver.steering_wheel_angle", "rad", {}},
             {"chassis.vx", "m/s", {}},
             {"chassis.yaw_rate", "rad/s", {}},
             {"chassis.ay", "m/s2", {}}}};
    for (int i = 0; 0.01 * i < seconds; ++i) {
        const double t = 0.01 * i, r = 0.15 * std::sin(2 * t), ripple = 1e-3 * std::sin(77.0 * i);
        const double values[] = {t, 0.4 * std::sin(2 * t + 0.1), 20 + ripple, r + 0.1 * ripple, 20 * r + ripple};
        for (std::size_t k = 0; k < 5; ++k) log.channels[k].values.push_back(values[k]);
    }
    return log;
}

class DiagnoseCommand : public testing::Test {
protected:
    Scratch scratch;

    void recorded(const std::string& name, const Log& log) const { writeLog(scratch.path(name), log); }
    std::string diagnosis(const std::string& more = "effects: [steering_ratio]\n",
                          const std::string& recordings = "  - {log: a.csv, speed: followed}\n") const {
        return scratch.file("diagnosis.yaml",
                            "vehicle: " + sourceFile("vehicles/compact.yaml") + "\nrecordings:\n" + recordings + more);
    }
    Result checked(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"diagnose", scratch.path("diagnosis.yaml"), "--check", "-o",
                                       scratch.path("out")};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    }

    void expectRefused(const Result& result, const std::string& words) const {
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    }
    void expectWarned(const Result& result, const std::string& words) const {
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.out.find(words), std::string::npos) << result.out;
    }
};

TEST_F(DiagnoseCommand, RefusesALogShorterThanASecond) {
    recorded("a.csv", slalom(0.6));
    diagnosis();
    expectRefused(checked(), "a shorter drive cannot separate causes");
}

TEST_F(DiagnoseCommand, TakesTheNameOfAShippedCar) {
    recorded("a.csv", slalom());
    diagnosis();
    const Result by_path = checked();
    scratch.file("diagnosis.yaml",
                 "vehicle: compact\nrecordings:\n  - {log: a.csv, speed: followed}\neffects: [steering_ratio]\n");
    const Result by_name = checked();
    EXPECT_EQ(by_name.status, by_path.status);
    EXPECT_EQ(by_name.out, by_path.out);
    EXPECT_EQ(checked({"--vehicle", "compact"}).out, by_path.out);
    expectRefused(checked({"--vehicle", "compakt"}), "compakt");
}

TEST_F(DiagnoseCommand, RefusesAnUnknownEffectAndNamesTheOneThatWasMeant) {
    recorded("a.csv", slalom());
    diagnosis("effects: [tyre_relaxatoin]\n");
    const Result result = checked();
    expectRefused(result, "did you mean \"tyre_relaxation\"?");
    EXPECT_NE(result.err.find("diagnosis.yaml:4:11: effects.0"), std::string::npos) << result.err;
}

TEST_F(DiagnoseCommand, RefusesAnEffectOfOnesOwnWhosePathDoesNotExist) {
    recorded("a.csv", slalom());
    scratch.file("own.yaml",
                 "catalogue:\n  - name: roof_box\n    question: Is there one?\n    source: guess\n    knobs:\n"
                 "      - {paths: [aero.drag_aera], typical: 0.2}\n");
    diagnosis("own_effects: own.yaml\n");
    const Result result = checked();
    expectRefused(result, "did you mean \"aero.drag_area\"?");
    EXPECT_NE(result.err.find("own.yaml:6:"), std::string::npos) << result.err;
}

TEST_F(DiagnoseCommand, RefusesWhenEveryRecordingIsHeldOut) {
    recorded("a.csv", slalom());
    diagnosis("", "  - {log: a.csv, hold_out: true}\n");
    expectRefused(checked(), "expected at least one recording to fit");
}

TEST_F(DiagnoseCommand, RefusesANameThatLeadsOutOfTheFolderOfTheAnswer) {
    recorded("a.csv", slalom());
    diagnosis("", "  - {log: a.csv, name: ../../a}\n");
    expectRefused(checked(), "expected a name without slashes");
}

TEST_F(DiagnoseCommand, RefusesARecordingAsItsOwnReference) {
    recorded("a.csv", slalom());
    diagnosis("", "  - {log: a.csv, reference: ./a.csv}\n");
    expectRefused(checked(), "found the recording itself");
}

TEST_F(DiagnoseCommand, SaysAtOnceThatADriveHeldOutCannotBeRepeated) {
    recorded("a.csv", slalom());
    Log without = slalom();
    std::erase_if(without.channels, [](const Channel& channel) { return channel.name == "chassis.vx"; });
    recorded("b.csv", without);
    diagnosis("effects: [steering_ratio]\n", "  - {log: a.csv, speed: followed}\n  - {log: b.csv, hold_out: true}\n");
    expectWarned(checked(), "recording b: found no speed in the first half second");
    const Result full = runProgram({"diagnose", scratch.path("diagnosis.yaml"), "-o", scratch.path("out")});
    EXPECT_EQ(full.status, 2);
    EXPECT_NE(full.err.find("recording b: found no speed"), std::string::npos) << full.err;
}

TEST_F(DiagnoseCommand, RefusesALimitOfTheCacheThatIsNoNumberBeforeTheWork) {
    recorded("a.csv", slalom(1.5));
    diagnosis("effects: [steering_delay]\n");
    setenv("TREAD_LARGEST_CACHE", "1 GB", 1);
    const Result result = runProgram({"diagnose", scratch.path("diagnosis.yaml"), "-o", scratch.path("out")});
    unsetenv("TREAD_LARGEST_CACHE");
    expectRefused(result, "TREAD_LARGEST_CACHE: found \"1 GB\", expected a whole number of bytes");
    EXPECT_FALSE(std::filesystem::exists(scratch.path("out/diagnosis.json")));
}

TEST_F(DiagnoseCommand, RefusesALogThatIsNotThereWithItsPlaceInTheFile) {
    diagnosis();
    expectRefused(checked(), "diagnosis.yaml:3:");
}

TEST_F(DiagnoseCommand, CheckFindsAYawRateOfTheWrongSign) {
    Log log = slalom();
    for (double& value : log.channels[3].values) value = -value;
    recorded("a.csv", log);
    diagnosis();
    expectWarned(checked(), "chassis.yaw_rate: has the opposite sign of chassis.ay");
}

TEST_F(DiagnoseCommand, CheckFindsASpeedInKilometresPerHour) {
    Log log = slalom();
    for (double& value : log.channels[2].values) value *= 3.6;
    recorded("a.csv", log);
    diagnosis();
    expectWarned(checked(), "as if one of them were in km/h");
}

TEST_F(DiagnoseCommand, CheckFindsInputsThatNeverMove) {
    Log log = slalom();
    for (std::size_t c : {1, 3, 4})
        for (double& value : log.channels[c].values) value = 0;
    recorded("a.csv", log);
    diagnosis();
    EXPECT_EQ(checked().status, 1);
}

TEST_F(DiagnoseCommand, CheckSaysWhatOneRecordingAloneCannotTell) {
    recorded("a.csv", slalom());
    diagnosis();
    const Result result = checked();
    expectWarned(result, "only one recording is used for fitting");
    expectWarned(result, "no recording is held out");
}

TEST_F(DiagnoseCommand, CheckFindsTheFileOfAnotherCar) {
    recorded("a.csv", slalom());
    diagnosis();
    EXPECT_EQ(checked().out.find("With the file of a different car"), std::string::npos);
    diagnosis("vehicle_settings: [steering.ratio=5]\neffects: [steering_ratio]\n");
    expectWarned(checked(), "With the file of a different car, every effect would be fitted to that difference");
}

TEST_F(DiagnoseCommand, CheckFindsGaps) {
    Log log = slalom();
    for (std::size_t i = 200; i < 260; ++i) log.channels[3].values[i] = std::nan("");
    recorded("a.csv", log);
    diagnosis();
    expectWarned(checked(), "chassis.yaw_rate");
}

TEST_F(DiagnoseCommand, CheckSaysWhatTheDrivesCouldShowWithoutADiagnosis) {
    recorded("a.csv", slalom());
    recorded("b.csv", slalom(9));
    recorded("c.csv", slalom(8));
    // A latency of the instruments would hide half of it.
    diagnosis("effects: [steering_delay, brake_gain]\ntolerances: [{path: instruments.latency}]\n",
              "  - {log: a.csv, speed: followed}\n  - {log: b.csv, speed: followed}\n"
              "  - {log: c.csv, speed: followed}\n");
    const Result text = checked();
    EXPECT_NE(firstLine(text.out).find("; 1 of 2 effects would be found"), std::string::npos) << text.out;
    const std::size_t found = text.out.find("CAN FIND"), hidden = text.out.find("NOT SEEN");
    ASSERT_TRUE(found < hidden && hidden != std::string::npos) << text.out;
    EXPECT_LT(text.out.find("steering_delay", found), hidden);
    EXPECT_NE(text.out.find("brake_gain", hidden), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(scratch.path("out/diagnosis.json")));

    const std::string with_cache = checked({"--json"}).out;
    const nlohmann::json json = nlohmann::json::parse(with_cache);
    EXPECT_EQ(json.at("can_be_found"), nlohmann::json::array({"steering_delay"}));
    EXPECT_EQ(json.at("cannot_be_seen"), nlohmann::json::array({"brake_gain"}));
    EXPECT_GT(json.at("expected_evidence").at("steering_delay"), 6);
    EXPECT_GT(std::filesystem::remove_all(scratch.path("out/cache")), 0u);
    EXPECT_EQ(checked({"--json"}).out, with_cache) << "the answer does not depend on what was kept";
}

TEST_F(DiagnoseCommand, WarnsOfImplausibleNumbersOfTheCarAndRefusesThemWithStrict) {
    recorded("a.csv", slalom());
    diagnosis("effects: [steering_ratio]\nvehicle_settings: [steering.ratio=17, aero.drag_area=66]\n");
    const std::string warning = scratch.path("diagnosis.yaml") +
                                ":5:39: aero.drag_area: found 66 m2, plausible values are 0.001 to 15 m2; check value "
                                "and unit\n";
    const Result result = checked();
    EXPECT_EQ(result.err.find("warning: " + warning), 0u) << result.err;
    const Result strict = checked({"--strict"});
    expectRefused(strict, warning);
    EXPECT_EQ(strict.err, warning);
}

TEST_F(DiagnoseCommand, ScenarioAsItsVehicleIsOneSentence) {
    recorded("a.csv", slalom());
    const std::string scenario = sourceFile("scenarios/step_steer_80.yaml");
    scratch.file("diagnosis.yaml", "vehicle: " + scenario + "\nrecordings:\n  - {log: a.csv, speed: followed}\n");
    const Result result = checked();
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, scenario +
                              ": found a scenario file, expected a vehicle file; `tread run` takes it after the "
                              "vehicle\n");
}

TEST_F(DiagnoseCommand, NamesAndValuesThatAreWrongAreToldTogether) {
    diagnosis("channels: [{channel: chassis.yawrate}]\nstep: 4\n");
    const Result result = checked();
    expectRefused(result, ": channels.0.channel: found the unknown channel");
    EXPECT_NE(result.err.find(": step: found"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(": recordings.0.log: found"), std::string::npos) << result.err;
}

TEST_F(DiagnoseCommand, InitWritesAFileThatCanBeRead) {
    recorded("a.csv", slalom());
    const Result made =
        runProgram({"diagnose", "--init", scratch.folder(), "--vehicle", sourceFile("vehicles/compact.yaml")});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_NE(contentOf(scratch.path("diagnosis.yaml")).find("speed: followed"), std::string::npos);
    EXPECT_NE(checked().status, 2);
    expectRefused(runProgram({"diagnose", "--init", scratch.folder()}), "exists already");
}

TEST_F(DiagnoseCommand, NeverBlamesWhatShortStraightDrivesCannotShow) {
    Log log = slalom(1.5);
    for (std::size_t c : {1, 3, 4})
        for (std::size_t i = 0; i < log.channels[c].values.size(); ++i)
            log.channels[c].values[i] = c == 1 ? 0 : 0.002 * std::sin(double(c) * 31.0 * static_cast<double>(i));
    recorded("a.csv", log);
    diagnosis("effects: [steering_delay, grip]\n");
    for (const char* const earlier : {"out/logs/b/nominal.csv", "out/logs/b/measured.csv", "out/logs/c/nominal.csv"}) {
        std::filesystem::create_directories(std::filesystem::path(scratch.path(earlier)).parent_path());
        scratch.file(earlier, "of an earlier call");
    }
    scratch.file("out/logs/c/notes.txt", "mine");
    const Result result =
        runProgram({"diagnose", scratch.path("diagnosis.yaml"), "-o", scratch.path("out"), "--threads", "1"});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_TRUE(result.out.starts_with("Not testable")) << result.out;
    EXPECT_NE(result.out.find("in-sample"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("NEXT      scenarios/"), std::string::npos) << result.out;
    for (const char* name :
         {"diagnosis.json", "report.html", "vehicle_with_effect.yaml", "cache", "logs/a/nominal.csv"})
        EXPECT_TRUE(std::filesystem::exists(scratch.path("out/") + name)) << name;
    EXPECT_FALSE(std::filesystem::exists(scratch.path("out/logs/b"))) << "a recording of an earlier call";
    EXPECT_FALSE(std::filesystem::exists(scratch.path("out/logs/c/nominal.csv")));
    EXPECT_EQ(contentOf(scratch.path("out/logs/c/notes.txt")), "mine");
}

TEST_F(DiagnoseCommand, AllDiagnosesOfAFolderInPartsGiveOneTable) {
    std::filesystem::create_directories(scratch.path("cars/first"));
    std::filesystem::create_directories(scratch.path("cars/second"));
    recorded("cars/first/a.csv", slalom(1.5));
    const std::string text = "vehicle: " + sourceFile("vehicles/compact.yaml") +
                             "\nrecordings:\n  - {log: a.csv, speed: followed}\neffects: [steering_delay]\n";
    scratch.file("cars/first/diagnosis.yaml", text);
    scratch.file("cars/second/diagnosis.yaml", text);  // whose log is missing
    const auto part = [&](const std::string& shard) {
        return runProgram({"diagnose", "--all", scratch.path("cars"), "-o", scratch.path("out"), "--shard", shard});
    };
    const Result first = part("1/2");
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_NE(first.out.find("part 1/2 is done"), std::string::npos) << first.out;
    EXPECT_FALSE(std::filesystem::exists(scratch.path("out/diagnoses.csv")));
    const auto written = std::filesystem::last_write_time(scratch.path("out/first/diagnosis.json"));

    const Result all = part("2/2");
    EXPECT_EQ(all.status, 3) << all.err;
    EXPECT_NE(all.out.find(" of 2 diagnoses answered, 1 failed"), std::string::npos) << all.out;
    const std::string table = contentOf(scratch.path("out/diagnoses.csv"));
    EXPECT_TRUE(
        table.starts_with("name,inputs,failure,answered,verdict,answer,causes,closed [-],remaining [-]\nfirst,"))
        << table;
    EXPECT_NE(table.find("\nsecond,"), std::string::npos) << table;
    EXPECT_NE(table.find("a.csv"), std::string::npos) << table;
    EXPECT_NE(contentOf(scratch.path("out/index.html")).find("first/report.html"), std::string::npos);
    EXPECT_EQ(std::filesystem::last_write_time(scratch.path("out/first/diagnosis.json")), written);

    // The same table again, and only what has changed is diagnosed anew.
    EXPECT_EQ(runProgram({"diagnose", "--all", scratch.path("cars"), "-o", scratch.path("out")}).status, 3);
    EXPECT_EQ(contentOf(scratch.path("out/diagnoses.csv")), table);
    EXPECT_EQ(std::filesystem::last_write_time(scratch.path("out/first/diagnosis.json")), written);
}

TEST_F(DiagnoseCommand, AllKilledAtAnyMomentInTwoPartsGoOnToTheSameBytes) {
    for (const std::string name : {"first", "second"}) {
        std::filesystem::create_directories(scratch.path("cars/" + name));
        recorded("cars/" + name + "/a.csv", slalom(name == "first" ? 1.5 : 1.2));
        scratch.file("cars/" + name + "/diagnosis.yaml",
                     "vehicle: " + sourceFile("vehicles/compact.yaml") +
                         "\nrecordings:\n  - {log: a.csv, speed: followed}\neffects: [steering_delay]\n");
    }
    const auto call = [&](const std::string& out, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"diagnose", "--all", scratch.path("cars"), "-o", scratch.path(out)};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    // All but times: those of the clock, and what is kept for a next diagnosis.
    const auto resultsIn = [&](const std::string& out) {
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path(out))) {
            const std::string name = entry.path().lexically_relative(scratch.path(out)).string();
            if (!entry.is_regular_file() || name.find("cache/") != std::string::npos || name == "claims") continue;
            std::string text = contentOf(entry.path());
            if (name.ends_with("diagnosis.json")) {
                auto json = nlohmann::json::parse(text);
                json.erase("seconds");
                text = json.dump();
            }
            files[name] = name.ends_with("report.html") ? "a page" : text;
        }
        return files;
    };
    const auto started = std::chrono::steady_clock::now();
    ASSERT_LE(runProgram(call("whole")).status, 1);
    const auto whole_call =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - started);
    int turn = 0;
    killAtRandom(
        8, whole_call,
        [&] {
            return call("killed", {"--shard", ++turn % 2 ? "1/2" : "2/2"});
        },
        [&] {  // nothing is left to kill: from the beginning
            const std::string killed = scratch.path("killed");
            if (std::filesystem::exists(killed + "/first/diagnosis.json") &&
                std::filesystem::exists(killed + "/second/diagnosis.json"))
                std::filesystem::remove_all(killed);
        });
    ASSERT_LE(runProgram(call("killed")).status, 1);
    EXPECT_EQ(resultsIn("killed"), resultsIn("whole"));
}

TEST_F(DiagnoseCommand, FolderThatCannotBeWrittenIsToldBeforeTheWork) {
    recorded("a.csv", slalom(1.5));
    diagnosis("effects: [steering_delay]\n");
    const std::string file = scratch.file("file", "");
    for (const auto& words :
         std::vector<std::vector<std::string>>{{"diagnose", scratch.path("diagnosis.yaml"), "-o", file + "/out"},
                                               {"diagnose", scratch.path("diagnosis.yaml"), "-o", "/proc/out"}}) {
        const Result result = runProgram(words);
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find("\ntread: cannot create the folder "), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }
}

TEST_F(DiagnoseCommand, AllOfAFolderWithoutDiagnosesIsRefused) {
    expectRefused(runProgram({"diagnose", "--all", scratch.folder(), "-o", scratch.path("out")}),
                  "found no folder with a diagnosis.yaml in this folder");
}

TEST_F(DiagnoseCommand, IdentifyRefusesAPathThatDoesNotExistWithAHint) {
    recorded("a.csv", slalom());
    diagnosis();
    expectRefused(runProgram({"identify", scratch.path("diagnosis.yaml"), "--fit", "steering.ration"}),
                  "did you mean \"steering.ratio\"?");
    diagnosis("fit: [mas]\n");
    const Result in_file = runProgram({"identify", scratch.path("diagnosis.yaml")});
    expectRefused(in_file, "did you mean \"mass\"?");
    EXPECT_NE(in_file.err.find("diagnosis.yaml:4:7"), std::string::npos) << in_file.err;
}

TEST_F(DiagnoseCommand, IdentifyHoldsOutWhatIsNamedAndRefusesAnUnknownName) {
    recorded("a.csv", slalom());
    diagnosis();
    const std::string file = scratch.path("diagnosis.yaml");
    expectRefused(runProgram({"identify", file, "--fit", "mass", "--without", "b.csv"}),
                  "found \"b.csv\", expected a recording of the file");
    expectRefused(runProgram({"identify", file, "--fit", "mass", "--without", "a.csv"}),
                  "found hold_out: true for every recording");
}

TEST_F(DiagnoseCommand, IdentifyRefusesANumberOfWhichNothingSaysHowWellItIsKnown) {
    recorded("a.csv", slalom());
    diagnosis();
    expectRefused(runProgram({"identify", scratch.path("diagnosis.yaml"), "--fit", "steering.delay"}),
                  "add one under tolerances");
}

}  // namespace
}  // namespace tread::diagnose_test
