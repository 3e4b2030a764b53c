#include <gtest/gtest.h>

#include "cli/program.h"

namespace tread {
namespace {

TEST(CommandLine, NothingIsAnsweredWithTheHelpAndStatusTwo) {
    const Result result = runProgram({});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    for (const char* command : {"run", "compare", "metrics", "tyre", "describe", "check", "schema"}) {
        EXPECT_NE(result.err.find(std::string("\n  ") + command + " "), std::string::npos) << command;
    }
}

TEST(CommandLine, VersionAndHelpAreAnswers) {
    const Result version = runProgram({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.out.find("tread "), 0u);
    EXPECT_EQ(version.err, "");
    const Result help = runProgram({"compare", "--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("--tolerances"), std::string::npos);
    EXPECT_EQ(help.err, "");
}

TEST(CommandLine, MistypedCommandIsAnsweredWithASuggestionAndTheList) {
    const Result result = runProgram({"runn", "a.yaml"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(
        result.err,
        "tread: there is no command \"runn\", only run, compare, metrics, import, tyre, diagnose, identify, blind, "
        "describe, check or schema; did "
        "you mean \"run\"?\n");
    EXPECT_EQ(runProgram({"frobnicate"}).err.find("did you mean"), std::string::npos) << "nothing is near";
}

TEST(CommandLine, EveryOtherMistakeIsOneSentence) {
    const auto answer = [](const std::vector<std::string>& arguments) {
        const Result result = runProgram(arguments);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
        return result.err;
    };
    EXPECT_EQ(answer({"compare", "a.csv", "b.csv", "--reprt=x.html"}),
              "tread compare: there is no option \"--reprt\"; did you mean \"--report\"? (`tread compare --help` shows "
              "how it is called)\n");
    EXPECT_EQ(answer({"compare", "a.csv", "--jsn", "b.csv"}).find("tread compare: there is no option \"--jsn\"; did "),
              0u);
    EXPECT_EQ(answer({"compare", "a.csv"}).find("tread compare: new is required"), 0u);
    EXPECT_EQ(answer({"compare", "a.csv", "b.csv", "c.csv"}).find("tread compare: there is no use for \"c.csv\""), 0u);
    EXPECT_EQ(answer({"metrics", "a.csv", "--manoeuvre"}).find("tread metrics: --manoeuvre: "), 0u);
    EXPECT_EQ(answer({"--jsn"}).find("tread: there is no option \"--jsn\""), 0u);
}

}  // namespace
}  // namespace tread
