// The commands that the README prints, run as printed and in their order.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "cli/program.h"

namespace tread::readme_test {
namespace {

// Lines of the README that call the program. The whole catalogue and whole diagnoses have tests of their own.
std::vector<std::string> printedCommands() {
    std::vector<std::string> commands;
    std::istringstream lines(contentOf(sourceFile("README.md")));
    for (std::string line; std::getline(lines, line);) {
        const bool is_long = line.find(" --all ") != std::string::npos || line.find("tread diagnose") == 0 ||
                             line.find("tread blind") == 0 || line.find("tread campaign") == 0;
        if (line.rfind("tread ", 0) == 0 && !is_long) commands.push_back(line);
    }
    return commands;
}

TEST(Readme, CommandsOfTheFirstFiveMinutesRunAsPrinted) {
    const Scratch scratch;
    for (const char* folder : {"vehicles", "scenarios", "tools"})
        std::filesystem::create_directory_symlink(sourceFile(folder), scratch.path(folder));
    const std::string begin = "cd " + scratch.folder() + "; tread() { " + programFile() + " \"$@\" >>log 2>&1; }; ";
    // What tools/run has made before.
    ASSERT_EQ(
        std::system(("bash -c '" + begin + "tread run vehicles/compact.yaml scenarios/step_steer_80.yaml'").c_str()),
        0);
    const std::vector<std::string> commands = printedCommands();
    EXPECT_GE(commands.size(), 10u);
    for (const std::string& command : commands) {
        const int state = std::system(("bash -c '" + begin + command + "'").c_str());
        const int expected = command.rfind("tread compare out/", 0) == 0 ? 1 : 0;  // two cars differ
        EXPECT_EQ(WEXITSTATUS(state), expected) << command << "\n" << contentOf(scratch.path("log"));
    }
}

}  // namespace
}  // namespace tread::readme_test
