// Ctrl-C in the middle of a run, and the progress that is shown until then.

#include <chrono>
#include <thread>
#include <utility>

#include "cli/tread_run.h"
#include "log/csv.h"

namespace tread::run_interrupt_test {
namespace {

// True when a file in the making has that many bytes before the time is over.
bool grows(const std::string& file, std::uintmax_t bytes) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(300);
    std::error_code error;
    while (std::chrono::steady_clock::now() < end) {
        for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
            const std::string path = entry.path().string();
            if (!path.starts_with(file + ".") || !path.ends_with(".tread.part")) continue;
            const std::uintmax_t size = entry.file_size(error);
            if (!error && size >= bytes) return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

class TreadRunInterrupted : public TreadRun, public testing::WithParamInterface<std::pair<int, int>> {};

TEST_P(TreadRunInterrupted, KeepsTheLogSoFarAndSaysWhere) {
    const auto [signal, status] = GetParam();
    car();
    scenario();
    Running program(words({"--set", "scenario.phases.0.until.duration=100000", "--set", "scenario.time_limit=200000"}),
                    scratch.path("stdout"), scratch.path("stderr"));
    ASSERT_TRUE(grows(out("log.csv"), 1));
    program.send(signal);
    EXPECT_EQ(program.waitForStatus(), status);

    EXPECT_EQ(results(), kFailedResults);
    const Log log = readLog(out("log.incomplete.csv"));
    ASSERT_GT(log.samples(), 1u);
    for (const Channel& channel : log.channels) EXPECT_EQ(channel.values.size(), log.samples());
    const std::string err = contentOf(scratch.path("stderr"));
    EXPECT_EQ(err.rfind("tread run: interrupted at t = ", 0), 0u) << err;
    EXPECT_TRUE(err.ends_with(" s; the rows so far are in '" + out("log.incomplete.csv") + "'\n")) << err;
    EXPECT_EQ(contentOf(scratch.path("stdout")), "");
}

INSTANTIATE_TEST_SUITE_P(By, TreadRunInterrupted,
                         testing::Values(std::pair(SIGINT, 130), std::pair(SIGTERM, 143), std::pair(SIGHUP, 129)),
                         [](const auto& by) {
                             const int signal = by.param.first;
                             return signal == SIGINT ? "CtrlC" : signal == SIGTERM ? "Termination" : "Hangup";
                         });

TEST_F(TreadRun, SecondCallIntoAFolderIsRefusedAndSaysWhoWritesThere) {
    car();
    scenario();
    const auto longer =
        words({"--set", "scenario.phases.0.until.duration=100000", "--set", "scenario.time_limit=200000"});
    Running first(longer, scratch.path("stdout"), scratch.path("stderr"));
    ASSERT_TRUE(grows(out("log.csv"), 1));
    const std::string resolved = contentOf(out("run.yaml"));
    const Result second = runProgram(words({}));
    EXPECT_EQ(second.status, 2);
    EXPECT_EQ(second.err.rfind("tread: process ", 0), 0u) << second.err;
    EXPECT_NE(second.err.find(" writes into the folder "), std::string::npos);
    EXPECT_EQ(contentOf(out("run.yaml")), resolved);

    Running waiting(words({"--wait"}), scratch.path("stdout2"), scratch.path("stderr2"));
    first.send(SIGTERM);
    EXPECT_EQ(first.waitForStatus(), 143);
    EXPECT_EQ(waiting.waitForStatus(), 0) << contentOf(scratch.path("stderr2"));
    EXPECT_TRUE(std::filesystem::exists(out("report.html")));
}

TEST_F(TreadRun, KilledCallLeavesAMarkThatOthersSee) {
    car();
    scenario();
    Running program(words({"--set", "scenario.phases.0.until.duration=100000", "--set", "scenario.time_limit=200000"}),
                    scratch.path("stdout"), scratch.path("stderr"));
    ASSERT_TRUE(grows(out("log.csv"), 1));
    program.send(SIGKILL);
    program.waitForStatus();
    const Result compared = runProgram({"compare", out(""), out("")});
    EXPECT_NE(compared.status, 0);
    EXPECT_NE((compared.out + compared.err).find("is incomplete: its run was killed or has not ended"),
              std::string::npos)
        << compared.out << compared.err;
    std::filesystem::copy_file(sourceFile("tests/golden/bump.csv"), out("log.csv"));
    for (const Names& reading : {Names{"metrics", out("log.csv")}, Names{"compare", out("log.csv"), out("log.csv")},
                                 Names{"log", out("log.csv"), "-o", scratch.path("again.csv")}}) {
        const Result refused = runProgram(reading);
        EXPECT_EQ(refused.status, 2) << reading.front();
        EXPECT_EQ(
            refused.err,
            out("log.csv") +
                ": lies in a folder that is marked as incomplete: a call of tread is writing into it, or was killed "
                "while doing so; run it again, or remove " +
                out("INCOMPLETE") + " to read what is there\n");
    }
    const Result updated = runProgram({"compare", scratch.path("baseline"), out(""), "--update"});
    EXPECT_EQ(updated.status, 2);
    EXPECT_NE(updated.err.find("is incomplete, expected a whole run for the baseline"), std::string::npos)
        << updated.err;
    EXPECT_FALSE(std::filesystem::exists(scratch.path("baseline")));
    EXPECT_EQ(runProgram(words({})).status, 0);
    EXPECT_EQ(results(), kAllResults) << "nothing is left of the killed call";
    EXPECT_EQ(runProgram({"compare", out(""), out("")}).status, 0);
}

TEST_F(TreadRun, InterruptIsHeardBetweenRowsThatAreFarApart) {
    car();
    scenario();
    Running program(words({"--set", "scenario.phases.0.until.duration=100000", "--set", "scenario.time_limit=200000",
                           "--set", "scenario.log.rate=0.0005"}),
                    scratch.path("stdout"), scratch.path("stderr"));
    ASSERT_TRUE(grows(out("log.csv"), 0));
    program.send(SIGINT);
    EXPECT_EQ(program.waitForStatus(), 130);
    EXPECT_EQ(readLog(out("log.incomplete.csv")).samples(), 1u);
}

TEST_F(TreadRun, ProgressIsShownOnATerminalAndWipedBeforeTheMessage) {
    car();
    scenario();
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0) GTEST_SKIP() << "this system has no pseudo-terminals (/dev/pts)";
    ASSERT_EQ(grantpt(terminal), 0);
    ASSERT_EQ(unlockpt(terminal), 0);
    Running program(words({"--set", "scenario.phases.0.until.duration=100000", "--set", "scenario.time_limit=200000"}),
                    scratch.path("stdout"), ptsname(terminal));

    std::string shown;
    char piece[256];
    bool interrupted = false;
    for (ssize_t size = 0; (size = read(terminal, piece, sizeof piece)) > 0;) {
        shown.append(piece, static_cast<std::size_t>(size));
        if (!interrupted && shown.find(" left (") != std::string::npos) {
            interrupted = true;
            program.send(SIGINT);
        }
    }
    close(terminal);
    EXPECT_EQ(program.waitForStatus(), 130);
    EXPECT_EQ(shown.front(), '\r') << shown;
    EXPECT_NE(shown.find("\r\033[Ktread run: interrupted at t = "), std::string::npos) << shown;
}

}  // namespace
}  // namespace tread::run_interrupt_test
