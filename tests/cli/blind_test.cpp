// `tread blind`: cases are made with a sealed key, and nothing of the key lies among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "blind/answers/answer.h"
#include "blind/key/key.h"
#include "cli/answered_check.h"
#include "cli/program.h"
#include "diagnose/answer/diagnosis.h"
#include "places/places.h"
#include "shared/scratch.h"
#include "store/sha256.h"

namespace tread::blind_test {
namespace {

using blind::key::parseKey;
using blind::key::programHash;
using blind::key::SealedKey;

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

TEST(BlindCommand, KeyRecordsTheProgramThatMadeTheCases) {
    const Scratch scratch;
    ASSERT_EQ(runProgram(make(scratch, {"--kinds", "none"})).status, 0);
    const SealedKey key = parseKey(contentOf(scratch.path("cases.key.json")), "key");
    EXPECT_EQ(key.program, programHash());
}

struct ScoredCheck : AnsweredCheck {
    Scratch scratch;

    Result scored(const std::string& answers, std::vector<std::string> more = {}) const {
        write(scratch.path("cases"), scratch.path(answers), scratch.path("key.json"));
        std::vector<std::string> line{
            "blind", "score", scratch.path("cases"), scratch.path("key.json"), "-o", scratch.path("out")};
        line.insert(line.end(), more.begin(), more.end());
        return runProgram(line);
    }
};

TEST(BlindCommand, CheckByOneProgramIsCalledFrozenAndByTwoIsNot) {
    ScoredCheck check;
    const Result frozen = check.scored("out/answers");
    ASSERT_EQ(frozen.status, 0) << frozen.err;
    EXPECT_EQ(firstLine(frozen.out).find("Blind check of 1 cases, frozen: one effect named first in 1 of 1"), 0u)
        << frozen.out;
    EXPECT_TRUE(nlohmann::json::parse(contentOf(check.scratch.path("out/score.json"))).at("frozen"));
    check.key.program.diagnosis = std::string(64, '0');
    const Result other = check.scored("out/answers");
    EXPECT_NE(other.out.find("NOT frozen: the key records program 000000000000"), std::string::npos) << other.out;
    EXPECT_NE(contentOf(check.scratch.path("out/report.html")).find("not frozen"), std::string::npos);
}

TEST(BlindCommand, ScoreWithoutReferencesHasAFolderOfItsOwn) {
    const ScoredCheck check;
    const Result scored = check.scored("out/without_references/answers", {"--no-references"});
    ASSERT_EQ(scored.status, 0) << scored.err;
    EXPECT_NE(scored.out.find("diagnosed without references"), std::string::npos) << scored.out;
    EXPECT_TRUE(std::filesystem::exists(check.scratch.path("out/without_references/report.html")));
    EXPECT_FALSE(std::filesystem::exists(check.scratch.path("out/score.json")));
}

TEST(BlindCommand, KeyThatDoesNotSayWhatTheDrivesShowIsRefused) {
    ScoredCheck check;
    check.key.cases[0].shows.clear();
    const Result scored = check.scored("out/answers");
    EXPECT_EQ(scored.status, 2);
    EXPECT_NE(scored.err.find("drag_area"), std::string::npos) << scored.err;
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
}  // namespace tread::blind_test
