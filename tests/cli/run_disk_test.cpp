// `tread run` where it may not write, and where the disk is full.

#include "cli/tread_run.h"
#include "log/csv.h"
#include "shared/file_size_limit.h"

namespace tread::run_disk_test {
namespace {

TEST_F(TreadRun, OutputBelowAFileIsRefused) {
    const std::string file = car();
    scenario();
    const Result result = runProgram({"run", file, scratch.path("scenario.yaml"), "-o", file + "/out"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err,
              "tread: cannot create the folder " + file + "/out: Not a directory; choose another with -o\n");
}

TEST_F(TreadRun, OutputThatCannotBeWrittenIsRefused) {
    car();
    scenario();
    for (const std::string folder : {"/proc/tread/out", "/dev/null/x"}) {
        const Result result =
            runProgram({"run", scratch.path("car.yaml"), scratch.path("scenario.yaml"), "-o", folder});
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        expectStart(result.err, "tread: cannot create the folder " + folder + ": ");
        EXPECT_TRUE(result.err.ends_with("; choose another with -o\n")) << result.err;
    }
}

TEST_F(TreadRun, EarlierResultThatCannotBeReplacedIsRefused) {
    car();
    scenario();
    std::filesystem::create_directories(out("log.csv/in the way"));
    const Result result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "tread: cannot remove " + out("log.csv") +
                              ", left by an earlier call: Directory not empty; choose another folder with -o\n");
}

TEST_F(TreadRun, LogThatFillsTheDiskKeepsItsWholeRows) {
    car();
    scenario(replaced(kScenario, "0.2 s", "2 s") + "log: {rate: 1000}\n");
    Result result;
    {
        const FileSizeLimit limit(200'000);
        result = run();
    }
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "tread: cannot write '" + out("log.csv") + "': File too large; the rows so far are in '" +
                              out("log.incomplete.csv") + "'\n");
    EXPECT_EQ(results(), (Names{"INCOMPLETE", "log.incomplete.csv", "run.yaml"}));
    const Log log = readLog(out("log.incomplete.csv"));
    EXPECT_GT(log.samples(), 50u);
    EXPECT_EQ(log.channels[0].values[7], 0.007);
    EXPECT_GT(std::filesystem::file_size(out("log.incomplete.csv")), 190'000u);
}

TEST_F(TreadRun, ReportThatFillsTheDiskLeavesTheLogAndNoReport) {
    car();
    scenario();
    Result result;
    {
        const FileSizeLimit limit(45'000);
        result = run({"--set", "scenario.log.rate=50"});
    }
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "tread: cannot write '" + out("report.html") + "': File too large\n");
    EXPECT_EQ(results(), (Names{"INCOMPLETE", "log.csv", "metrics.json", "run.yaml"}));
    EXPECT_GT(parseLog(contentOf(out("log.csv")), "log.csv").samples(), 10u);
}

}  // namespace
}  // namespace tread::run_disk_test
