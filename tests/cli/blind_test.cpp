// `tread blind`: cases are made with a sealed key, and nothing of the key lies among them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "places/places.h"
#include "shared/scratch.h"
#include "store/sha256.h"

namespace tread {
namespace {

std::vector<std::string> make(const Scratch& scratch, std::vector<std::string> more = {}) {
    std::vector<std::string> line{"blind",     "make",
                                  "--cases",   "1",
                                  "--seed",    "3",
                                  "--vehicle", sourceFile("vehicles/compact.yaml"),
                                  "-o",        scratch.path("cases")};
    line.insert(line.end(), more.begin(), more.end());
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

TEST(BlindCommand, UnknownKindIsRefusedWithTheKindsThatThereAre) {
    const Scratch scratch;
    const Result made = runProgram(make(scratch, {"--kinds", "onne"}));
    EXPECT_EQ(made.status, 2);
    EXPECT_NE(made.err.find("outside"), std::string::npos) << made.err;
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
