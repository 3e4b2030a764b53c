#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "log/csv.h"
#include "shared/foreign_logs.h"

namespace tread {
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
    EXPECT_EQ(result.err,
              "chassis.vx: km/h to m/s\n"
              "chassis.yaw_rate: deg/s to rad/s\n"
              "chassis.yaw_rate: sign turned\n"
              "chassis.ay: g to m/s2\n"
              "not taken: Steering wheel angle\n");
    const Log imported = readLog(log);
    EXPECT_NEAR(imported.find("chassis.yaw_rate")->values[100], foreign::yawRate(1), 1e-8);
    EXPECT_EQ(runProgram({"check", log}).status, 0);
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
              Json({{"kind", "sign"}, {"channel", "chassis.yaw_rate"}, {"count", 501}, {"text", "sign turned"}}));
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
    EXPECT_NE(without.err.find("have opposite signs"), std::string::npos) << "and doubted, as its yaw rate is z down";
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
    EXPECT_EQ(result.err, wrong + ":3:33: map.0.from: found \"Sped\", which is no column of " + table +
                              "; did you mean \"Speed\"?\n" + wrong +
                              ":5:11: map.1.from: found a speed (\"km/h\", the unit of column \"Speed\"), expected an "
                              "acceleration (m/s2); correct the unit or the channel\n");
    EXPECT_FALSE(std::filesystem::exists(log));
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
}  // namespace tread
