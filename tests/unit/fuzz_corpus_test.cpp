// Replays the corpora of the fuzzers: what once was, or could be, a crash.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/csv_entry.h"
#include "fuzz/height_field_entry.h"
#include "fuzz/tir_entry.h"
#include "fuzz/yaml_entry.h"
#include "places/places.h"
#include "shared/scratch.h"

namespace tread::fuzz_corpus_test {
namespace {

struct Replay {
    std::size_t files = 0;
    std::vector<std::string> taken;  // sorted
};

Replay replay(const std::string& corpus, bool (*reads)(std::string_view text)) {
    Replay replay;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFile("tests/fuzz/corpus/" + corpus))) {
        SCOPED_TRACE(entry.path().string());
        if (reads(contentOf(entry.path()))) replay.taken.push_back(entry.path().filename());
        ++replay.files;
    }
    std::sort(replay.taken.begin(), replay.taken.end());
    return replay;
}

TEST(FuzzCorpus, EveryYamlFileIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("yaml", fuzz::readHostileYaml);
    EXPECT_GE(files, 20u);
    EXPECT_EQ(taken, (std::vector<std::string>{"bom.yaml", "everything.yaml", "tyre.yaml"}));
}

TEST(FuzzCorpus, EveryLogIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("csv", fuzz::readHostileCsv);
    EXPECT_GE(files, 8u);
    EXPECT_EQ(taken, (std::vector<std::string>{"plain.csv", "windows.csv"}));
}

TEST(FuzzCorpus, EveryHeightFieldIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("height_field", fuzz::readHostileHeights);
    EXPECT_GE(files, 9u);
    EXPECT_EQ(taken, (std::vector<std::string>{"plain.csv"}));
}

TEST(FuzzCorpus, EveryTyrePropertyFileIsTakenOrRefusedInWords) {
    const auto [files, taken] = replay("tir", fuzz::readHostileTir);
    EXPECT_GE(files, 14u);
    EXPECT_EQ(taken, (std::vector<std::string>{"latin1.tir", "plain.tir", "tables.tir", "units.tir", "windows.tir"}));
}

}  // namespace
}  // namespace tread::fuzz_corpus_test
