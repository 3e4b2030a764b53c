// When a blind check is frozen, and which sources the hashes of the program cover.
#include "blind/score/frozen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "places/places.h"
#include "shared/scratch.h"
#include "store/sha256.h"

namespace tread::blind_frozen_test {
namespace {

using blind::answers::CaseAnswer;
using blind::key::Program;
using blind::key::programHash;
using blind::score::frozen;
using blind::score::Frozen;

const Program kOwn{.diagnosis = std::string(64, 'a'), .scoring = std::string(64, 'b')};

std::vector<CaseAnswer> answersBy(const std::vector<std::string>& programs) {
    std::vector<CaseAnswer> answers;
    for (const std::string& program : programs) {
        CaseAnswer& answer = answers.emplace_back();
        answer.program = {.diagnosis = program, .scoring = kOwn.scoring};
    }
    return answers;
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(BlindFrozen, OneProgramForAllIsFrozen) {
    const Frozen all = frozen(kOwn, answersBy({kOwn.diagnosis, kOwn.diagnosis}), kOwn);
    EXPECT_TRUE(all.frozen);
    EXPECT_TRUE(all.scoring);
    EXPECT_EQ(all.words, "frozen: cases, answers and this score are of program aaaaaaaaaaaa");
}

TEST(BlindFrozen, OtherProgramOfKeyOrAnswerOrScoreIsNamed) {
    const std::string other(64, 'c');
    const Frozen of_key = frozen({other, kOwn.scoring}, answersBy({kOwn.diagnosis}), kOwn);
    EXPECT_FALSE(of_key.frozen);
    EXPECT_EQ(
        of_key.words,
        "NOT frozen: the key records program cccccccccccc, the answers were given by program aaaaaaaaaaaa, this is "
        "program aaaaaaaaaaaa");
    const Frozen of_one = frozen(kOwn, answersBy({kOwn.diagnosis, other}), kOwn);
    EXPECT_FALSE(of_one.frozen);
    EXPECT_TRUE(holds(of_one.words, "given by program aaaaaaaaaaaa and program cccccccccccc")) << of_one.words;
    const Frozen of_score = frozen({other, kOwn.scoring}, answersBy({other}), kOwn);
    EXPECT_FALSE(of_score.frozen);
    EXPECT_TRUE(holds(of_score.words, "this is program aaaaaaaaaaaa")) << of_score.words;
}

TEST(BlindFrozen, WhatDoesNotSayItsProgramIsNotFrozen) {
    EXPECT_FALSE(frozen({}, answersBy({kOwn.diagnosis}), kOwn).frozen);
    EXPECT_TRUE(holds(frozen({}, {}, kOwn).words, "no program that is known"));
    EXPECT_FALSE(frozen({}, answersBy({""}), {}).frozen);
    EXPECT_FALSE(frozen(kOwn, {}, kOwn).frozen);
}

TEST(BlindFrozen, OtherScoringAloneLeavesItFrozenAndIsSaid) {
    const Frozen changed = frozen({kOwn.diagnosis, std::string(64, 'd')}, answersBy({kOwn.diagnosis}), kOwn);
    EXPECT_TRUE(changed.frozen);
    EXPECT_FALSE(changed.scoring);
    EXPECT_TRUE(holds(changed.words, "the examiner's scoring changed: the key records program dddddddddddd"))
        << changed.words;
}

// ---- The hash, computed independently of the build ----

namespace fs = std::filesystem;

void addFiles(std::vector<std::string>& paths, const std::string& folder, const std::vector<std::string>& endings) {
    for (const auto& entry : fs::recursive_directory_iterator(sourceFile(folder))) {
        if (std::find(endings.begin(), endings.end(), entry.path().extension()) == endings.end()) continue;
        paths.push_back(fs::relative(entry.path(), sourceFile("")).generic_string());
    }
}

// SHA-256 of the output of `sha256sum`.
std::string hashOf(std::vector<std::string> paths) {
    std::sort(paths.begin(), paths.end());
    std::string sums;
    for (const std::string& path : paths) sums += sha256(contentOf(sourceFile(path))) + "  " + path + "\n";
    return sha256(sums);
}

TEST(ProgramHash, IsThatOfTheSourcesThatItNames) {
    std::vector<std::string> all{"CMakeLists.txt"}, scoring;
    for (const char* folder : {"include", "src"}) addFiles(all, folder, {".cpp", ".h"});
    for (const char* folder : {"src/report", "tools/tread"})
        addFiles(scoring, folder, {".cpp", ".h", ".cmake", ".css", ".js"});
    addFiles(scoring, "src/blind/score", {".cpp", ".h"});
    scoring.insert(scoring.end(), {"src/blind/key/program_hash.cmake", "src/blind/key/program_hash.h"});
    std::erase_if(all,
                  [&](const auto& path) { return std::find(scoring.begin(), scoring.end(), path) != scoring.end(); });
    EXPECT_GT(all.size(), 200u);
    EXPECT_EQ(programHash().diagnosis, hashOf(all)) << "or a source was edited after the build";
    EXPECT_EQ(programHash().scoring, hashOf(scoring)) << "or a source was edited after the build";
}

TEST(ProgramHash, EditedSourceChangesTheHashThatItBelongsTo) {
    const Scratch scratch;
    for (const char* name :
         {"src/vehicle/car.cpp", "src/blind/score/score.cpp", "include/tread/car.h", "CMakeLists.txt"}) {
        fs::create_directories(fs::path(scratch.path(name)).parent_path());
        scratch.file(name, "first");
    }
    const auto generated = [&] {
        const std::string line = "cmake -DROOT=" + scratch.folder() + " -DOUTPUT=" + scratch.path("hash.cpp") + " -P " +
                                 sourceFile("src/blind/key/program_hash.cmake");
        EXPECT_EQ(std::system(line.c_str()), 0);
        const std::string text = contentOf(scratch.path("hash.cpp"));
        const auto after = [&](const char* mark) {
            return text.substr(text.find(mark) + std::string(mark).size(), 64);
        };
        return Program{.diagnosis = after(".diagnosis = \""), .scoring = after(".scoring = \"")};
    };
    const Program first = generated();
    const auto written = fs::last_write_time(scratch.path("hash.cpp"));
    EXPECT_EQ(generated(), first);
    EXPECT_EQ(fs::last_write_time(scratch.path("hash.cpp")), written) << "nothing to compile where nothing changed";
    scratch.file("src/blind/score/score.cpp", "second");
    const Program scored = generated();
    EXPECT_EQ(scored.diagnosis, first.diagnosis);
    EXPECT_NE(scored.scoring, first.scoring);
    for (const char* name : {"src/vehicle/car.cpp", "include/tread/car.h", "CMakeLists.txt"}) {
        const Program before = generated();
        scratch.file(name, "second");
        EXPECT_NE(generated().diagnosis, before.diagnosis) << name;
        EXPECT_EQ(generated().scoring, before.scoring) << name;
    }
}

}  // namespace
}  // namespace tread::blind_frozen_test
