#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "report/embedded.h"
#include "shared/scratch.h"

namespace tread {
namespace {

int shell(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str());
}

TEST(PageScripts, EveryScriptParses) {
    if (shell("command -v node") != 0) GTEST_SKIP() << "node is not installed";
    const Scratch scratch;
    for (const std::string_view script :
         {embedded::kValuesScript, embedded::kChartsScript, embedded::kReplayRoadScript, embedded::kReplayCarScript,
          embedded::kReplayScript, embedded::kThreeScript, embedded::kThreeOrbit}) {
        const std::string file = scratch.file("script.js", std::string(script));
        EXPECT_EQ(shell("node --check '" + file + "'"), 0) << script.substr(0, 100);
    }
    EXPECT_NE(shell("node --check '" + scratch.file("broken.js", "const a = ;") + "'"), 0) << "node finds a fault";
}

}  // namespace
}  // namespace tread
