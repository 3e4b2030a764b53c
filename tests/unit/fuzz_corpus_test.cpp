// Replays the corpora of the fuzzers: what once was, or could be, a crash.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/csv_entry.h"
#include "fuzz/yaml_entry.h"

namespace tread {
namespace {

struct Replay {
    std::size_t files = 0;
    std::vector<std::string> taken;  // names of the files that were taken, sorted
};

Replay replay(const std::string& corpus, bool (*read)(std::string_view)) {
    Replay result;
    for (const auto& entry : std::filesystem::directory_iterator(TREAD_SOURCE_DIR "/tests/fuzz/corpus/" + corpus)) {
        SCOPED_TRACE(entry.path().string());
        std::ifstream stream(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        if (read(text)) result.taken.push_back(entry.path().filename());
        ++result.files;
    }
    std::sort(result.taken.begin(), result.taken.end());
    return result;
}

using Names = std::vector<std::string>;

TEST(FuzzCorpus, EveryYamlFileIsTakenOrRefusedInWords) {
    const Replay yaml = replay("yaml", fuzz::readHostileYaml);
    EXPECT_GE(yaml.files, 20u);
    EXPECT_EQ(yaml.taken, (Names{"bom.yaml", "everything.yaml", "tyre.yaml"}));
}

TEST(FuzzCorpus, EveryCsvFileIsTakenOrRefusedInWords) {
    const Replay csv = replay("csv", fuzz::readHostileCsv);
    EXPECT_GE(csv.files, 8u);
    EXPECT_EQ(csv.taken, (Names{"plain.csv", "windows.csv"}));
}

}  // namespace
}  // namespace tread
