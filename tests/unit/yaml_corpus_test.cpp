// Replays the corpus of the YAML fuzzer: what once was, or could be, a crash.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "fuzz/yaml_entry.h"
#include "shared/scratch.h"

namespace tread {
namespace {

TEST(YamlCorpus, EveryFileIsTakenOrRefusedInWords) {
    std::vector<std::string> taken;
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(TREAD_SOURCE_DIR "/tests/fuzz/corpus/yaml")) {
        SCOPED_TRACE(entry.path().string());
        if (fuzz::readHostileYaml(contentOf(entry.path()))) taken.push_back(entry.path().filename());
        ++files;
    }
    std::sort(taken.begin(), taken.end());
    EXPECT_GE(files, 20u);
    EXPECT_EQ(taken, (std::vector<std::string>{"bom.yaml", "everything.yaml", "tyre.yaml"}));
}

}  // namespace
}  // namespace tread
