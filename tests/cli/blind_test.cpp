// `tread blind`: cases are made with a sealed key, and nothing of the key lies among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "diagnose/sha256.h"
#include "places/places.h"
#include "shared/scratch.h"

namespace tread {
namespace {

std::vector<std::string> make(const Scratch& scratch, std::vector<std::string> more = {}) {
    std::vector<std::string> line{"blind",     "make",
                                  "--cases",   "1",
                                  "--seed",    "3",
                                  "--vehicle", sourceFile("vehicles/compact.yaml"),
                                  "-o",        scratch.path("cases")};
    line.insert(line.end(), more.begin(), more.end());
    // A car with which nothing is wrong is made soonest.
    if (std::find(more.begin(), more.end(), "--kinds") == more.end()) line.insert(line.end(), {"--kinds", "none"});
    return line;
}

TEST(BlindCommand, HashThatIsPrintedIsThatOfTheKey) {
    const Scratch scratch;
    const Result made = runProgram(make(scratch, {"--json"}));
    ASSERT_EQ(made.status, 0) << made.err;
    const auto json = nlohmann::json::parse(made.out);
    EXPECT_EQ(json.at("key_sha256"), sha256(contentOf(scratch.path("cases.key.json"))));
    EXPECT_TRUE(std::filesystem::exists(scratch.path("cases/case_001/diagnosis.yaml")));
    EXPECT_FALSE(std::filesystem::exists(scratch.path("cases/cases.key.json")));
}

TEST(BlindCommand, KeyIsNeverOverwritten) {
    const Scratch scratch;
    scratch.file("cases.key.json", "sealed");
    const Result made = runProgram(make(scratch));
    EXPECT_EQ(made.status, 2);
    EXPECT_NE(made.err.find("--key"), std::string::npos) << made.err;
    EXPECT_EQ(contentOf(scratch.path("cases.key.json")), "sealed");
}

TEST(BlindCommand, UnknownKindOrWorldIsRefusedWithThoseThatThereAre) {
    const Scratch scratch;
    const Result kind = runProgram(make(scratch, {"--kinds", "onne"}));
    EXPECT_EQ(kind.status, 2);
    EXPECT_NE(kind.err.find("mixed"), std::string::npos) << kind.err;
    const Result world = runProgram(make(scratch, {"--world", "real"}));
    EXPECT_EQ(world.status, 2);
    EXPECT_NE(world.err.find("assumed"), std::string::npos) << world.err;
}

TEST(BlindCommand, WorldIsTheExaminersOwnUnlessToldOtherwise) {
    const Scratch scratch;
    const auto made = [&](const std::string& place, const std::vector<std::string>& more) {
        std::vector<std::string> line = make(scratch, more);
        line.insert(line.end(), {"--key", scratch.path(place + ".json")});
        *std::find(line.begin(), line.end(), scratch.path("cases")) = scratch.path(place);
        const Result result = runProgram(line);
        EXPECT_EQ(result.status, 0) << result.err;
        return nlohmann::json::parse(contentOf(scratch.path(place + ".json")));
    };
    const auto own = made("own", {}), assumed = made("assumed", {"--world", "assumed", "--frozen"});
    EXPECT_EQ(own.at("world"), "own");
    EXPECT_EQ(own.at("frozen"), false);
    EXPECT_EQ(assumed.at("world"), "assumed");
    EXPECT_EQ(assumed.at("frozen"), true);
    EXPECT_NE(contentOf(scratch.path("own/case_001/coast_down_120.csv")),
              contentOf(scratch.path("assumed/case_001/coast_down_120.csv")));
}

TEST(BlindCommand, KeySaysWhatTheDrivesShowOfEveryFault) {
    const Scratch scratch;
    const Result made = runProgram(make(scratch, {"--kinds", "mixed", "--drives", "coast_and_accelerate"}));
    ASSERT_EQ(made.status, 0) << made.err;
    const auto key = nlohmann::json::parse(contentOf(scratch.path("cases.key.json")));
    const auto& one = key.at("cases").at(0);
    for (const std::string name : {one.at("effects").at(0), one.at("outsider")}) {
        const auto& shows = one.at("shows").at(name);
        EXPECT_GE(shows.at("nats").get<double>(), shows.at("separation").get<double>()) << name;
        EXPECT_NE(shows.at("rival"), "") << name;
    }
}

TEST(BlindCommand, FewDrivesAreMadeAndNamedInTheKey) {
    const Scratch scratch;
    const Result made = runProgram(make(scratch, {"--drives", "coast_and_accelerate"}));
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_TRUE(std::filesystem::exists(scratch.path("cases/case_001/coast_down_120.csv")));
    EXPECT_FALSE(std::filesystem::exists(scratch.path("cases/case_001/sine_sweep_90.csv")));
    const auto key = nlohmann::json::parse(contentOf(scratch.path("cases.key.json")));
    EXPECT_EQ(key.at("drives"), "coast_and_accelerate");
}

TEST(BlindCommand, FolderWithoutCasesIsRefused) {
    const Scratch scratch;
    scratch.file("key.json", "{}");
    const Result scored =
        runProgram({"blind", "score", scratch.folder(), scratch.path("key.json"), "-o", scratch.path("out")});
    EXPECT_EQ(scored.status, 2);
    EXPECT_NE(scored.err.find("tread blind make"), std::string::npos) << scored.err;
}

}  // namespace
}  // namespace tread
