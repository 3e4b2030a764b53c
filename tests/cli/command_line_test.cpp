#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "cli/program.h"

namespace tread::command_line_test {
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
    EXPECT_EQ(result.err,
              "tread: there is no command \"runn\", only run, compare, metrics, import, tyre, diagnose, identify, "
              "blind, campaign, fmu, log, "
              "describe, check, schema, man or completions; did "
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
              "its usage)\n");
    EXPECT_EQ(answer({"compare", "a.csv", "--jsn", "b.csv"}).find("tread compare: there is no option \"--jsn\"; did "),
              0u);
    EXPECT_EQ(answer({"compare", "a.csv"}).find("tread compare: new is required"), 0u);
    EXPECT_EQ(answer({"compare", "a.csv", "b.csv", "c.csv"}).find("tread compare: unexpected argument \"c.csv\""), 0u);
    EXPECT_EQ(answer({"metrics", "a.csv", "--manoeuvre"}).find("tread metrics: --manoeuvre: "), 0u);
    EXPECT_EQ(answer({"--jsn"}).find("tread: there is no option \"--jsn\""), 0u);
}

// ---- At a terminal ----

const std::string kSedan = sourceFile("vehicles/rear_drive_sedan.yaml");

TEST(Terminal, ShowsTheResultInColourUnlessToldOtherwise) {
    const Result good = runInTerminal({"check", kSedan});
    EXPECT_EQ(good.status, 0);
    EXPECT_EQ(good.out.find("\033[1;32m"), 0u) << good.out;
    const Scratch scratch;
    EXPECT_EQ(runInTerminal({"check", scratch.file("a.yaml", "mass: 1 kg\n")}).out.find("\033[1;31m"), 0u);
    EXPECT_EQ(runProgram({"check", kSedan}).out.find('\033'), std::string::npos) << "a pipe takes no colours";
    setenv("NO_COLOR", "1", 1);
    EXPECT_EQ(runInTerminal({"check", kSedan}).out.find('\033'), std::string::npos);
    unsetenv("NO_COLOR");
}

TEST(Terminal, ShowsHowFarLongWorkIs) {
    const Scratch scratch;
    const std::string road = scratch.file("long.yaml",
                                          "title: long\ntime_limit: 3000 s\nstart: {speed: 20 m/s}\n"
                                          "phases:\n  - {until: {time: 2500 s}}\n");
    const Result result =
        runInTerminal({"run", kSedan, road, "-o", scratch.path("out"), "--set", "scenario.step=0.02"});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_NE(result.out.find("#"), std::string::npos);
    EXPECT_NE(result.out.find(" left ("), std::string::npos) << result.out;
}

TEST(Terminal, LinesOfDescribeFitIt) {
    std::istringstream lines(runInTerminal({"describe", "scenario"}).out);
    for (std::string line; std::getline(lines, line);) {
        line.erase(line.find_last_not_of('\r') + 1);
        EXPECT_LE(line.size(), 80u) << line;
    }
}

TEST(CommandLine, QuietLeavesOnlyErrorsAndWhatWasAskedFor) {
    const Result checked = runProgram({"check", kSedan, "--quiet"});
    EXPECT_EQ(checked.status, 0);
    EXPECT_EQ(checked.out + checked.err, "");
    EXPECT_EQ(runProgram({"-q", "check", kSedan}).out, "");
    EXPECT_NE(runProgram({"check", kSedan, "--json", "-q"}).out, "");
    EXPECT_EQ(runProgram({"blind", "score", "no_such", "no_such", "-o", "no_such", "-q"}).err.find("no option"),
              std::string::npos);
    const Result wrong = runProgram({"metrics", "no_such.csv", "-q"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_NE(wrong.err, "");
}

// ---- Guides ----

TEST(Guides, ManPageHasEveryCommandAndOption) {
    const Result page = runProgram({"man"});
    EXPECT_EQ(page.status, 0);
    EXPECT_EQ(page.out.find(".TH TREAD 1"), 0u);
    for (const char* command : {"run", "compare", "blind make", "schema"}) {
        EXPECT_NE(page.out.find(std::string(".SS tread ") + command + "\n"), std::string::npos) << command;
    }
    EXPECT_NE(page.out.find("\\fB\\-\\-tolerances\\fR \\fIFILE\\fR"), std::string::npos);
    EXPECT_NE(page.out.find(".SH EXIT STATUS"), std::string::npos);
    std::istringstream lines(page.out);
    for (std::string line; std::getline(lines, line);) EXPECT_FALSE(line.empty()) << "an empty line is a fault in man";
}

// What bash offers behind these words.
std::string offered(const Scratch& scratch, const std::string& words) {
    const std::string script = scratch.file("complete.bash", runProgram({"completions", "bash"}).out);
    const std::string answer = scratch.path("answer");
    const std::string ask = "cd " + scratch.folder() + "; source " + script + "; COMP_WORDS=(" + words +
                            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _tread; echo \" ${COMPREPLY[*]} \" > " + answer;
    EXPECT_EQ(std::system(("bash -c '" + ask + "'").c_str()), 0);
    return contentOf(answer);
}

TEST(Guides, BashCompletesCommandsOptionsValuesAndFiles) {
    const Scratch scratch;
    scratch.file("car.yaml", "");
    EXPECT_EQ(offered(scratch, "tread ide"), " identify \n");
    EXPECT_EQ(offered(scratch, "tread blind \"\""), " make score \n");
    EXPECT_EQ(offered(scratch, "tread compare --tol"), " --tolerances \n");
    EXPECT_EQ(offered(scratch, "tread blind make --fro"), " --frozen \n");
    EXPECT_EQ(offered(scratch, "tread tyre --axes \"\""), " paper iso \n");
    EXPECT_EQ(offered(scratch, "tread run ca"), " car.yaml \n");
    EXPECT_NE(offered(scratch, "tread describe veh").find(" vehicle "), std::string::npos);
    EXPECT_NE(offered(scratch, "tread run --qu").find(" --quiet "), std::string::npos);
}

TEST(Guides, OtherShellsGetEveryCommandAndOption) {
    for (const std::string shell : {"zsh", "fish"}) {
        const Result result = runProgram({"completions", shell});
        EXPECT_EQ(result.status, 0);
        for (const char* word : {"identify", "tolerances", "frozen", "paper iso"}) {
            EXPECT_NE(result.out.find(word), std::string::npos) << shell << ": " << word;
        }
        // Where the shell is installed, it must understand its file.
        const Scratch scratch;
        const std::string file = scratch.file("completions", result.out);
        if (std::system(("command -v " + shell + " >/dev/null").c_str()) == 0) {
            EXPECT_EQ(std::system((shell + " -n " + file).c_str()), 0);
        }
    }
    EXPECT_EQ(runProgram({"completions", "tcsh"}).status, 2);
}

}  // namespace
}  // namespace tread::command_line_test
