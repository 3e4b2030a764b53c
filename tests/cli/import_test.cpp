#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "log/csv.h"
#include "shared/foreign_logs.h"

namespace tread::import_test {
namespace {

using Json = nlohmann::json;

struct Import : testing::Test {
    Scratch scratch;
    std::string table = scratch.file("drive.csv", foreign::table(foreign::loggerColumns(), foreign::times()));
    std::string map = scratch.file("map.yaml",
                                   "time: {from: Time}\n"
                                   "map:\n"
                                   "  - {channel: chassis.vx, from: Speed}\n"
                                   "  - {channel: chassis.yaw_rate, from: Yaw rate, sign: -1}\n"
                                   "  - {channel: chassis.ay, from: Lateral acceleration}\n");
    std::string log = scratch.path("log.csv");
};

TEST_F(Import, WritesALogAndSaysWhatItChanged) {
    const Result result = runProgram({"import", table, "--map", map, "-o", log});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "Imported drive.csv: 3 channels, 501 samples, 5 s, into " + log + "\n");
    EXPECT_EQ(
        result.err,
        "chassis.vx: km/h to m/s\nchassis.yaw_rate: deg/s to rad/s\nchassis.yaw_rate: sign reversed\nchassis.ay: g "
        "to m/s2\nnot taken: Steering wheel angle\nlacking: no steering: tread run --log and diagnose cannot "
        "repeat the steering; map a column to driver.steering_wheel_angle; the angle of the road wheels times "
        "the steering ratio (scale) can be used instead\n");
    const Log imported = readLog(log);
    EXPECT_NEAR(imported.find("chassis.yaw_rate")->values[100], foreign::yawRate(1), 1e-8);
    EXPECT_EQ(runProgram({"check", log}).status, 0);
}

TEST_F(Import, McapOfALogComesBackAsThatLog) {
    ASSERT_EQ(runProgram({"import", table, "--map", map, "-o", log}).status, 0);
    const std::string mcap = scratch.path("log.mcap"), back = scratch.path("back.csv");
    const Result convert = runProgram({"log", log, "--mcap"});
    EXPECT_EQ(convert.status, 0) << convert.err;
    EXPECT_EQ(convert.err, "log: " + mcap + "\n");
    const Result result = runProgram({"import", mcap, "-o", back});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(contentOf(back), contentOf(log));
    EXPECT_NE(runProgram({"metrics", mcap}).err.find("found an MCAP recording"), std::string::npos);

    const Result wrong = runProgram({"log", log, "--mcap", "-o", scratch.path("x.csv")});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_NE(wrong.err.find("expected a name that ends with .mcap"), std::string::npos) << wrong.err;
    const Result bag = runProgram({"import", scratch.file("drive.db3", "SQLite format 3"), "-o", back});
    EXPECT_EQ(bag.status, 2);
    EXPECT_NE(bag.err.find("`ros2 bag convert`"), std::string::npos) << bag.err;
}

TEST_F(Import, TheSameAsJson) {
    const Result result = runProgram({"import", table, "--map", map, "-o", log, "--json"});
    EXPECT_EQ(result.err, "");
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["output"], Json({log}));
    EXPECT_EQ(json["rows"], 501);
    EXPECT_EQ(json["not_taken"], Json({"Steering wheel angle"}));
    ASSERT_EQ(json["changes"].size(), 4u);
    EXPECT_EQ(json["changes"][2],
              Json({{"kind", "sign"}, {"channel", "chassis.yaw_rate"}, {"count", 501}, {"text", "sign reversed"}}));
    EXPECT_EQ(json["guessed_mapping"], nullptr);
}

TEST_F(Import, GuessesAMappingWritesItAndTakesItBack) {
    const std::string guessed = scratch.path("guessed.yaml");
    const Result init = runProgram({"import", table, "--init", guessed});
    EXPECT_EQ(init.status, 0) << init.err;
    EXPECT_EQ(init.out,
              "Guessed 4 channels of drive.csv; correct " + guessed + " and import with --map " + guessed + "\n");
    EXPECT_EQ(runProgram({"check", guessed}).status, 0);
    EXPECT_FALSE(std::filesystem::exists(log));

    const Result without = runProgram({"import", table, "-o", log});
    EXPECT_EQ(without.status, 0);
    EXPECT_NE(without.err.find(contentOf(guessed)), std::string::npos) << "the guess is shown";
    EXPECT_NE(without.err.find("guess: column Yaw rate has the opposite sign of "), std::string::npos)
        << "it is z down";
    EXPECT_NEAR(readLog(log).find("chassis.yaw_rate")->values[100], foreign::yawRate(1), 1e-8);
    const std::string first = contentOf(log);
    EXPECT_EQ(runProgram({"import", table, "--map", guessed, "-o", log}).status, 0);
    EXPECT_EQ(contentOf(log), first);
}

TEST_F(Import, FaultsOfTheMappingStandAtTheirPlaceInIt) {
    const std::string wrong = scratch.file("wrong.yaml",
                                           "time: {from: Time}\n"
                                           "map:\n"
                                           "  - {channel: chassis.vx, from: Sped}\n"
                                           "  - channel: chassis.ay\n"
                                           "    from: Speed\n");
    const Result result = runProgram({"import", table, "--map", wrong, "-o", log});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, wrong + ":3:33: map.0.from: found \"Sped\", which is not a column of " + table +
                              "; did you mean \"Speed\"?\n" + wrong +
                              ":5:11: map.1.from: found a speed (\"km/h\", the unit of column \"Speed\"), expected an "
                              "acceleration (m/s2); correct the unit or the channel\n");
    EXPECT_FALSE(std::filesystem::exists(log));
}

TEST_F(Import, EveryGuessStandsInTheMappingAsAComment) {
    const std::string bare = scratch.file(
        "bare.csv", foreign::table({{"t", "", [](double t) { return 1000 * t; }},
                                    {"SteerAng", "", [](double t) { return 100 * foreign::steering(t); }},
                                    {"velocity", "", [](double) { return 3.6 * 60; }},
                                    {"yawrate", "", [](double t) { return 57.29578 * foreign::yawRate(t); }}},
                                   foreign::times(), {.units_below = false}));
    const std::string guessed = scratch.path("guessed.yaml");
    EXPECT_EQ(runProgram({"import", bare, "--init", guessed}).status, 0);
    const std::string mapping = contentOf(guessed);
    EXPECT_NE(mapping.find("    from: SteerAng  # guess by the name\n    unit: deg  # guess: values peak at 50, "),
              std::string::npos)
        << mapping;
    EXPECT_NE(mapping.find("    unit: km/h  # guess: values peak at 216, plausible in km/h\n"), std::string::npos);
    EXPECT_NE(mapping.find("    unit: deg/s  # guess: "), std::string::npos);
    EXPECT_NE(mapping.find("  unit: ms  # guess: its usual step is 10\n"), std::string::npos);
    EXPECT_EQ(runProgram({"check", guessed}).status, 0);
    EXPECT_EQ(runProgram({"import", bare, "--map", guessed, "-o", log}).status, 0);
    EXPECT_NEAR(readLog(log).find("chassis.vx")->values[0], 60, 1e-9);
}

TEST_F(Import, NamesWhatALogNeedsAndDoesNotHave) {
    const std::string poor = scratch.file("poor.csv", "t [s],temperature [degC]\n0,1\n0.1,2\n0.2,3\n");
    const std::string mapping =
        scratch.file("poor.yaml", "time: {from: t}\nmap: [{channel: own.temperature, from: temperature}]\n");
    const Result result = runProgram({"import", poor, "--map", mapping, "-o", log});
    EXPECT_EQ(result.status, 0);
    for (const char* name :
         {"lacking: no speed: ", "lacking: no steering: ", "lacking: no yaw rate or lateral acceleration: "}) {
        EXPECT_NE(result.err.find(name), std::string::npos) << result.err;
    }
    EXPECT_EQ(result.err.find("lacking: no time"), std::string::npos);
    const Json guessed = Json::parse(runProgram({"import", table, "--init", scratch.path("g.yaml"), "--json"}).out);
    EXPECT_EQ(guessed["lacking"], Json::array());
}

TEST_F(Import, WithoutAnOutputTheLogIsWrittenBesideItsSource) {
    const Result result = runProgram({"import", table, "--map", map});
    EXPECT_EQ(result.status, 0) << result.err;
    const std::string beside = scratch.path("drive.tread.csv");
    EXPECT_NE(result.out.find("into " + beside + "\n"), std::string::npos) << result.out;
    EXPECT_EQ(readLog(beside).samples(), 501u);
    const Result again = runProgram({"import", table, "--map", map});
    EXPECT_EQ(again.status, 2);
    EXPECT_NE(again.err.find("'" + beside + "' is there already"), std::string::npos) << again.err;
}

TEST_F(Import, NeverWritesOverWhatItReads) {
    const std::string source = contentOf(table), mapping = contentOf(map);
    EXPECT_EQ(runProgram({"import", table, "--map", map, "-o", table}).status, 2);
    EXPECT_EQ(runProgram({"import", table, "--map", map, "-o", map}).status, 2);
    const Result init = runProgram({"import", table, "--init", scratch.path("./drive.csv")});
    EXPECT_EQ(init.status, 2);
    EXPECT_NE(init.err.find("--init names '" + scratch.path("./drive.csv") + "', which is read"), std::string::npos)
        << init.err;
    EXPECT_EQ(contentOf(table), source);
    EXPECT_EQ(contentOf(map), mapping);
}

TEST_F(Import, AMistypedChannelOrKeyIsAFaultAtItsPlace) {
    const auto faultOf = [&](const std::string& line) {
        const std::string wrong = scratch.file("wrong.yaml", "time: {from: Time}\nmap:\n" + line);
        const Result result = runProgram({"import", table, "--map", wrong, "-o", log});
        EXPECT_EQ(result.status, 2) << line;
        EXPECT_EQ(result.err.find(wrong + ":3:"), 0u) << result.err;
        const Result checked = runProgram({"check", wrong});
        EXPECT_EQ(checked.status, 2) << line;
        EXPECT_NE((checked.out + checked.err).find(result.err), std::string::npos) << checked.out << checked.err;
        return result.err.substr(std::min(result.err.size(), wrong.size()));
    };
    EXPECT_EQ(faultOf("  - {channel: chassis.yawrate, from: Yaw rate}\n"),
              ":3:15: map.0.channel: found \"chassis.yawrate\", which is not a channel of tread; did you mean "
              "\"chassis.yaw_rate\"? A channel of your own needs another name, like own.yawrate\n");
    const auto suggests = [&](const std::string& wrong, const std::string& meant) {
        const std::string fault = faultOf("  - {channel: " + wrong + ", from: Yaw rate}\n");
        EXPECT_NE(fault.find(":3:15: map.0.channel: found \"" + wrong), std::string::npos) << fault;
        EXPECT_NE(fault.find("did you mean \"" + meant + "\"?"), std::string::npos) << fault;
    };
    suggests("chasis.yaw_rate@can", "chassis.yaw_rate@can");
    suggests("wheel.front_lfet.spin", "wheel.front_left.spin");
    suggests("driver.steering_weel_angle", "driver.steering_wheel_angle");
    suggests("yaw_rate", "chassis.yaw_rate");
    EXPECT_NE(faultOf("  - {channel: chassis.omega, from: Yaw rate}\n").find("expected of chassis one of x, y, z"),
              std::string::npos);
    EXPECT_NE(faultOf("  - {chanel: chassis.vx, from: Speed}\n").find("did you mean \"channel\"?"), std::string::npos);
}

TEST_F(Import, AChannelOfOnesOwnHasAnyOtherName) {
    for (const char* own : {"own.yawrate", "can.brake_switch", "steering.road_wheel_angle", "path.distance", "own.x"}) {
        const std::string mapping = scratch.file(
            "own.yaml", std::string("time: {from: Time}\nmap:\n  - {channel: ") + own + ", from: Speed}\n");
        EXPECT_EQ(runProgram({"import", table, "--map", mapping, "-o", log}).status, 0) << own;
    }
}

TEST_F(Import, RecordingsBehindAJumpOfTimeBecomeLogsOfTheirOwn) {
    std::vector<double> times = foreign::times(100);
    for (int i = 0; i < 50; ++i) times.push_back(20 + 0.01 * i);
    const std::string torn = scratch.file("torn.csv", foreign::table(foreign::loggerColumns(), times));
    const std::string split = scratch.file("split.yaml", contentOf(map) + "repairs: {at_jump: split}\n");
    const Result result = runProgram({"import", torn, "--map", split, "-o", log});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(readLog(scratch.path("log_1.csv")).samples(), 100u);
    EXPECT_EQ(readLog(scratch.path("log_2.csv")).samples(), 50u);
    EXPECT_EQ(runProgram({"import", torn, "--map", map, "-o", log}).status, 0);
    EXPECT_EQ(readLog(log).samples(), 100u) << "the longest, unless the mapping says otherwise";
}

TEST_F(Import, ReadsAVboxFileByItsNameOrItsContent) {
    for (const char* name : {"drive.vbo", "drive.txt"}) {
        const std::string vbo = scratch.file(name, foreign::vbo(foreign::times()));
        const Result result = runProgram({"import", vbo, "-o", log, "--json"});
        EXPECT_EQ(Json::parse(result.out)["kind"], "VBOX file") << name;
        EXPECT_NEAR(readLog(log).find("chassis.vx")->values[0], foreign::kSpeed, 1e-4);
    }
}

TEST_F(Import, MakesATyreOfATirFile) {
    const std::string yaml = scratch.path("tyre.yaml");
    const std::string tir = scratch.file("x.tir", "[MODEL]\nPROPERTY_FILE_FORMAT = 'NO_SUCH'\n");
    const Result foreign = runProgram({"import", tir, "-o", yaml});
    EXPECT_EQ(foreign.status, 2);
    EXPECT_EQ(foreign.err.find(tir + ":"), 0u) << foreign.err;
    EXPECT_FALSE(std::filesystem::exists(yaml));
    EXPECT_EQ(runProgram({"import", tir, "--map", map}).status, 2);
}

// Empty files in place of matio: only the import of a MATLAB file fails.
TEST_F(Import, MatlabFilesNeedALibraryThatOthersDoNot) {
    std::filesystem::create_directory(scratch.path("lib"));
    for (int version = 0; version < 100; ++version) scratch.file("lib/libmatio.so." + std::to_string(version), "");
    setenv("LD_LIBRARY_PATH", scratch.path("lib").c_str(), 1);
    const std::string matlab = sourceFile("tests/fuzz/corpus/mat/v5.mat");
    const Result refused = runProgram({"import", matlab, "-o", log});
    const Result other = runProgram({"import", table, "--map", map, "-o", log});
    unsetenv("LD_LIBRARY_PATH");
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err.find(matlab + ": is a MATLAB file, and matio, the library that reads it, cannot"), 0u)
        << refused.err;
    EXPECT_NE(refused.err.find("; install matio"), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(other.status, 0) << other.err;
}

TEST_F(Import, NeverOverwritesAFileThatWasNotNamed) {
    const Result nowhere = runProgram({"import", scratch.path("none.vbo"), "-o", log});
    EXPECT_EQ(nowhere.status, 2);
    EXPECT_EQ(nowhere.err, "tread: cannot read '" + scratch.path("none.vbo") + "': No such file or directory\n");
    const std::string binary = scratch.file("x.mat", "no matlab");
    const Result foreign = runProgram({"import", binary, "-o", log});
    EXPECT_EQ(foreign.status, 2);
    EXPECT_EQ(foreign.err, binary + ": is cut off within its variable number 1: 11 bytes are missing\n");
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"drive.csv", "map.yaml", "x.mat"}));
}

}  // namespace
}  // namespace tread::import_test
