#include "log/csv.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <random>

#include "shared/file_size_limit.h"
#include "shared/scratch.h"

namespace tread::log_csv_test {
namespace {

namespace fs = std::filesystem;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class LogCsv : public testing::Test {
protected:
    fs::path at(const char* name) const { return scratch.path(name); }

    Scratch scratch;
};

std::vector<Problem> problemsOf(std::string_view text) {
    try {
        parseLog(text, "x.csv");
    } catch (const LoadError& error) {
        EXPECT_FALSE(std::string(error.what()).empty());
        return error.problems();
    }
    return {};
}

// The only fault of the text as "line:column: text".
std::string onlyFault(std::string_view text) {
    const auto problems = problemsOf(text);
    if (problems.size() != 1) return std::to_string(problems.size()) + " faults";
    return std::to_string(problems[0].line) + ":" + std::to_string(problems[0].column) + ": " + problems[0].text;
}

// ---- Writing -------------------------------------------------------------------------------------------------------

TEST_F(LogCsv, RowsAreShortestRoundTripUnderOneHeader) {
    LogWriter writer(at("a.csv"), {{"time", "s"}, {"driver.brake", "-"}});
    writer.write(std::vector{0.1, 1.0 / 3.0});
    writer.write(std::vector{0.30000000000000004, -kNan});
    writer.finish();
    EXPECT_EQ(contentOf(at("a.csv")), "time [s],driver.brake [-]\n0.1,0.3333333333333333\n0.30000000000000004,nan\n");
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"a.csv"});
}

TEST_F(LogCsv, EveryBitPatternSurvivesTheRoundTrip) {
    std::mt19937_64 random(7);
    Log log{{{"time", "s", {}}, {"a", "N m", {}}, {"odd, \"name\"", "m/s2", {}}}};
    const auto anyDouble = [&] { return std::bit_cast<double>(random()); };
    for (int i = 0; i < 20000; ++i) {
        log.channels[0].values.push_back(i * 0.001);
        log.channels[1].values.push_back(anyDouble());
        log.channels[2].values.push_back(i % 2 ? std::numeric_limits<double>::denorm_min() * i : anyDouble());
    }
    writeLog(at("a.csv"), log);
    const Log read = readLog(at("a.csv"));
    ASSERT_EQ(read.channels.size(), 3u);
    EXPECT_EQ(read.channels[1].unit, "N m");
    EXPECT_EQ(read.channels[2].name, "odd, \"name\"");
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < log.samples(); ++i) {
            const double expected = log.channels[c].values[i], got = read.channels[c].values[i];
            if (std::isnan(expected)) {
                ASSERT_TRUE(std::isnan(got));
            } else {
                ASSERT_EQ(std::bit_cast<std::uint64_t>(expected), std::bit_cast<std::uint64_t>(got));
            }
        }
    }
}

TEST_F(LogCsv, AWriterThatIsNotFinishedLeavesItsRowsUnderANameThatSaysSo) {
    {
        LogWriter writer(at("a.csv"), {{"time", "s"}});
        writer.write(std::vector{0.5});
        ASSERT_EQ(scratch.names().size(), 1u);
        EXPECT_TRUE(scratch.names().front().ends_with(".tread.part"));
    }
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"a.incomplete.csv"});
    EXPECT_EQ(readLog(at("a.incomplete.csv")).channels[0].values, std::vector{0.5});
}

TEST_F(LogCsv, WhatBecomesOfTheRowsIsTold) {
    {
        LogWriter writer(at("none.csv"), {{"time", "s"}});
        EXPECT_EQ(writer.keepIncomplete(), "no row was written");
    }
    EXPECT_TRUE(scratch.names().empty());
    {
        LogWriter writer(at("a.csv"), {{"time", "s"}});
        writer.write(std::vector{0.5});
        EXPECT_EQ(writer.keepIncomplete(), "the rows so far are in '" + at("a.incomplete.csv").string() + "'");
    }
    fs::create_directory(at("b.incomplete.csv"));
    {
        LogWriter writer(at("b.csv"), {{"time", "s"}});
        writer.write(std::vector{0.25});
        EXPECT_EQ(writer.keepIncomplete(),
                  "no row was kept: cannot write '" + at("b.incomplete.csv").string() + "': Is a directory");
    }
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"a.incomplete.csv", "b.incomplete.csv"}));
}

TEST_F(LogCsv, FinishingReplacesAnOlderLog) {
    std::ofstream(at("a.csv")) << "old";
    LogWriter writer(at("a.csv"), {{"time", "s"}});
    writer.write(std::vector{1.0});
    EXPECT_EQ(contentOf(at("a.csv")), "old") << "the old log stays until the new one is whole";
    writer.finish();
    EXPECT_EQ(contentOf(at("a.csv")), "time [s]\n1\n");
}

TEST_F(LogCsv, AFolderThatDoesNotExistIsOneClearSentence) {
    try {
        LogWriter writer(at("no/such/a.csv"), {{"time", "s"}});
        FAIL();
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot write '" + at("no/such/a.csv").string() + "': No such file or directory");
    }
}

TEST_F(LogCsv, AFullDiskIsReportedAtTheLatestWhenFinishing) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
    fs::create_symlink("/dev/full", at("a.csv"));
    LogWriter writer(at("a.csv"), {{"time", "s"}});
    writer.write(std::vector{1.0});
    try {
        writer.finish();
        FAIL();
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot write '" + at("a.csv").string() + "': No space left on device; no row was written");
    }
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"a.csv"}) << "the link stays";
}

TEST_F(LogCsv, AShortWriteKeepsTheWholeRowsAndCutsTheTornOne) {
    std::signal(SIGXFSZ, SIG_IGN);
    bool failed = false;
    try {
        LogWriter writer(at("a.csv"), {{"time", "s"}, {"a", "m"}});
        const FileSizeLimit limit(100'003);  // inside the second flush, inside a row
        for (int i = 0; i < 100'000; ++i) writer.write(std::vector{i * 0.25, 1.0 / (i + 3)});
    } catch (const FileError& error) {
        failed = true;
        EXPECT_NE(std::string(error.what()).find("a.incomplete.csv"), std::string::npos) << error.what();
    }
    ASSERT_TRUE(failed);
    EXPECT_FALSE(fs::exists(at("a.csv")));
    const Log kept = readLog(at("a.incomplete.csv"));
    EXPECT_GT(kept.samples(), 3000u);
    EXPECT_EQ(kept.channels[1].values.back(), 1.0 / (static_cast<int>(kept.samples()) + 2));
}

TEST_F(LogCsv, ColumnsThatCouldNotBeReadBackAreNotWritten) {
    EXPECT_THROW(LogWriter(at("a.csv"), {}), FileError);
    EXPECT_THROW(LogWriter(at("a.csv"), {{"a", "m"}}), FileError);
    EXPECT_THROW(LogWriter(at("a.csv"), {{"time", "s"}, {"a", ""}}), FileError);
    EXPECT_THROW(LogWriter(at("a.csv"), {{"time", "s"}, {"a\nb", "m"}}), FileError);
    EXPECT_TRUE(scratch.names().empty());
}

// ---- Reading: what is accepted -------------------------------------------------------------------------------------

TEST_F(LogCsv, WindowsLineEndsByteOrderMarkCommentsAndQuotesAreAccepted) {
    const Log log = parseLog(
        "\xEF\xBB\xBF# a comment, with commas\r\n\"time [s]\" , \"a, b [m]\"\r\n0, 1\r\n# between\r\n1 "
        ",\t-2.5e-3\r\n\r\n",
        "x.csv");
    ASSERT_EQ(log.channels.size(), 2u);
    EXPECT_EQ(log.channels[1].name, "a, b");
    EXPECT_EQ(log.channels[1].unit, "m");
    EXPECT_EQ(log.channels[1].values, (std::vector{1.0, -2.5e-3}));
}

TEST_F(LogCsv, TheLastLineNeedsNoLineEnd) {
    EXPECT_EQ(parseLog("time [s]\n0\n1", "x").samples(), 2u);
}

TEST_F(LogCsv, AnUnknownUnitIsKeptAsText) {
    EXPECT_EQ(parseLog("time [s],a [furlong]\n0,1\n", "x").channels[1].unit, "furlong");
}

TEST_F(LogCsv, ValuesThatAreNotFiniteAreReadOutsideTheTimeColumn) {
    const Log log = parseLog("time [s],a [m]\n0,nan\n1,-inf\n", "x");
    EXPECT_TRUE(std::isnan(log.channels[1].values[0]));
    EXPECT_EQ(log.channels[1].values[1], -std::numeric_limits<double>::infinity());
}

// ---- Reading: faults have a place ----------------------------------------------------------------------------------

TEST_F(LogCsv, RaggedRowsAreFaults) {
    EXPECT_EQ(onlyFault("time [s],a [m]\n0,1\n1\n"), "3:1: the row has 1 value, the header has 2 columns");
    EXPECT_EQ(onlyFault("time [s],a [m]\n0,1,2\n"), "2:3: the row has 3 values, the header has 2 columns");
}

TEST_F(LogCsv, CellsThatAreNotNumbersAreFaults) {
    EXPECT_EQ(onlyFault("time [s],a [m]\n0,1\n1,abc\n"), "3:3: column 'a': 'abc' is not a number");
    EXPECT_EQ(onlyFault("time [s],a [m]\n0,1x\n"), "2:3: column 'a': '1x' is not a number");
    EXPECT_EQ(onlyFault("time [s],a [m],b [m]\n0,,1\n"), "2:3: column 'a': the cell is empty, expected a number");
    EXPECT_EQ(onlyFault("time [s],a [m]\n0,\n"), "2:3: column 'a': the cell is empty, expected a number");
    EXPECT_EQ(onlyFault("time [s],a [m]\n0,1e999\n"), "2:3: column 'a': '1e999' is not a number");
}

TEST_F(LogCsv, HeaderFaultsNameTheColumn) {
    EXPECT_EQ(onlyFault("time [s],a [m],a [m]\n0,1,2\n"), "1:16: column 'a' appears twice");
    EXPECT_EQ(onlyFault("time [s],a\n0,1\n"),
              "1:10: column 'a' has no unit, expected `name [unit]` (`[-]` for pure numbers)");
    EXPECT_EQ(onlyFault("time [s],\n0,1\n"), "1:10: column 2 has no name, expected `name [unit]`");
    EXPECT_EQ(onlyFault("a [m],time [s]\n0,1\n"), "1:1: the first column is 'a [m]', expected `time [s]`");
    EXPECT_EQ(onlyFault("time [ms]\n0\n"), "1:1: the first column is 'time [ms]', expected `time [s]`");
    EXPECT_EQ(onlyFault("time [s],\"a [m]\n0,1\n"), "1:10: unclosed quote in 'a [m]'");
    EXPECT_EQ(onlyFault("time [s],\"a\" [m]\n0,1\n"), "1:10: unclosed quote in 'a[m]'");
}

TEST_F(LogCsv, TheTimeMustBeFiniteAndIncrease) {
    EXPECT_EQ(onlyFault("time [s]\n0\nnan\n"), "3:1: the time is not finite");
    EXPECT_EQ(onlyFault("time [s]\n0\n1\n1\n"), "4:1: the time does not increase from one row to the next");
    EXPECT_EQ(onlyFault("time [s]\n1\n0\n"), "3:1: the time does not increase from one row to the next");
}

TEST_F(LogCsv, FilesWithoutALogAreFaults) {
    EXPECT_EQ(onlyFault(""), "0:0: is empty, expected a header of `name [unit]`");
    EXPECT_EQ(onlyFault("# only a comment\n"), "0:0: is empty, expected a header of `name [unit]`");
    EXPECT_EQ(onlyFault("time [s],a [m]\n"), "1:0: there are no rows below the header");
    EXPECT_EQ(onlyFault(std::string_view("time [s]\n0\0", 11)),
              "0:0: is not a text file, expected CSV with a header of `name [unit]`");
    EXPECT_EQ(onlyFault("\x89PNG\r\n\x1a\n"), "0:0: is not a text file, expected CSV with a header of `name [unit]`");
}

TEST_F(LogCsv, AllFaultsOfAFileComeInOneRunUpToTwenty) {
    EXPECT_EQ(problemsOf("time [s],a [m]\n0,x\n1,2\n2\n3,y\n").size(), 3u);
    std::string many = "time [s],a [m]\n";
    for (int i = 0; i < 100; ++i) many += "0,x\n";
    EXPECT_EQ(problemsOf(many).size(), 20u);
}

TEST_F(LogCsv, AFaultReadsFileLineColumnText) {
    try {
        parseLog("time [s],a [m]\n0,x\n1\n", "run/log.csv");
        FAIL();
    } catch (const LoadError& error) {
        EXPECT_STREQ(error.what(),
                     "run/log.csv:2:3: column 'a': 'x' is not a number\n"
                     "run/log.csv:3:1: the row has 1 value, the header has 2 columns");
    }
}

TEST_F(LogCsv, AMissingFileAndAFolderAreClearSentences) {
    try {
        readLog(at("none.csv"));
        FAIL();
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot read '" + at("none.csv").string() + "': No such file or directory");
    }
    EXPECT_THROW(readLog(scratch.folder()), FileError);
}

}  // namespace
}  // namespace tread::log_csv_test
