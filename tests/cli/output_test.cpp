// Where the program writes its answers: a file is whole or not there, and every refusal is one sentence.

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "cli/logs.h"
#include "cli/program.h"
#include "places/places.h"
#include "shared/file_size_limit.h"

namespace tread::output_test {
namespace {

const std::string kTyreFile = sourceFile("vehicles/tyres/car_205_60R15.yaml");

// Ways to have a file written; its name goes behind the words. Words with a dot are files of the test's folder.
struct Way {
    std::string name;
    std::vector<std::string> words;
};
std::ostream& operator<<(std::ostream& out, const Way& way) {
    return out << way.name;
}
const std::vector<Way> kWays{
    {"Table", {"tyre", kTyreFile, "--table", "slips.csv", "-o"}},
    {"Transient", {"tyre", kTyreFile, "--transient", "motion.csv", "-o"}},
    {"Plot", {"tyre", kTyreFile, "--plot"}},
    {"Overlay", {"compare", "log.csv", "log.csv", "--report"}},
    {"Schema", {"schema", "tyre", "-o"}},
    {"Import", {"import", "log.csv", "-o"}},
    {"Fmu", {"fmu", sourceFile("vehicles/compact.yaml"), "-o"}},
};

class OutputFiles : public testing::TestWithParam<Way> {
protected:
    OutputFiles() {
        std::string slips = "Fz,gamma,Vx,Vsx,Vsy\n", motion = "t,Vsx,Vsy,Vx,Omega,psidot,gamma,Fz\n";
        for (int i = 0; i < 100; ++i) {
            slips += "4000,0,20,0,1\n";
            motion += std::to_string(i) + "e-3,0,0,9,30,0,0,4000\n";
        }
        input.file("slips.csv", slips);
        input.file("motion.csv", motion);
        writeLog(input.path("log.csv"), cli::stepSteer());
    }

    Result write(const std::string& file) const {
        std::vector<std::string> words;
        for (const std::string& word : GetParam().words) {
            words.push_back(word.ends_with(".csv") ? input.path(word) : word);
        }
        words.push_back(file);
        return runProgram(words);
    }
    void expectRefused(const std::string& file, const std::string& reason) const {
        const Result result = write(file);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, "tread: cannot write '" + file + "': " + reason + "\n");
    }

    Scratch input, output;
};

TEST_P(OutputFiles, AreWhole) {
    EXPECT_EQ(write(output.path("new")).status, 0);
    const std::string content = contentOf(output.path("new"));
    EXPECT_GT(content.size(), 2000u);

    output.file("old", "old");
    std::filesystem::create_symlink("old", output.path("link"));
    EXPECT_EQ(write(output.path("link")).status, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(output.path("link"))) << "a link stays a link";
    EXPECT_EQ(contentOf(output.path("old")), content);
    std::filesystem::permissions(output.path("old"), std::filesystem::perms(0640));
    EXPECT_EQ(write(output.path("old")).status, 0);
    EXPECT_EQ(std::filesystem::status(output.path("old")).permissions(), std::filesystem::perms(0640));
    EXPECT_EQ(output.names(), (std::vector<std::string>{"link", "new", "old"}));
}

TEST_P(OutputFiles, AreRefusedWhereNoneCanBe) {
    std::filesystem::create_directory(output.path("folder"));
    expectRefused(output.path("folder"), "Is a directory");
    expectRefused(output.path("no/such"), "No such file or directory");
    expectRefused(output.file("file", "kept") + "/below", "Not a directory");
    EXPECT_EQ(output.names(), (std::vector<std::string>{"file", "folder"}));
    EXPECT_TRUE(std::filesystem::is_empty(output.path("folder")));

    if (geteuid() == 0) return;  // the superuser may write everywhere
    std::filesystem::permissions(output.path("folder"), std::filesystem::perms::owner_read);
    expectRefused(output.path("folder/file"), "Permission denied");
}

TEST_P(OutputFiles, AreTheOldOnesWhenTheDiskIsFull) {
    output.file("old", "old");
    {
        const FileSizeLimit limit(1000);
        expectRefused(output.path("old"), "File too large");
        expectRefused(output.path("new"), "File too large");
    }
    EXPECT_EQ(contentOf(output.path("old")), "old");
    EXPECT_EQ(output.names(), std::vector<std::string>{"old"});

    expectRefused("/dev/full", "No space left on device");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << "a device is not replaced by a file";
}

INSTANTIATE_TEST_SUITE_P(By, OutputFiles, testing::ValuesIn(kWays), [](const auto& way) { return way.param.name; });

// ---- Standard output ----

TEST(StandardOutput, ThatIsFullIsOneSentenceOfEveryCommand) {
    const Scratch scratch;
    const std::string log = scratch.path("log.csv");
    writeLog(log, cli::stepSteer());
    const std::string slips = scratch.file("slips.csv", "Fz,gamma,Vx,Vsx,Vsy\n4000,0,20,0,1\n");
    const std::string root = sourceFile();
    const std::vector<std::vector<std::string>> answers{
        {"run", root + "/vehicles/compact.yaml", root + "/scenarios/drop_and_settle.yaml", "-o", scratch.path("out")},
        {"--version"},
        {"run", "--help"},
        {"describe", "tyre"},
        {"describe", "metrics", "--json"},
        {"schema", "tyre"},
        {"check", kTyreFile},
        {"compare", log, log},
        {"metrics", log},
        {"tyre", kTyreFile},
        {"tyre", kTyreFile, "--json"},
        {"tyre", kTyreFile, "--plot", scratch.path("plot.html")},
        {"tyre", kTyreFile, "--table", slips},
    };
    for (const std::vector<std::string>& words : answers) {
        SCOPED_TRACE(testing::PrintToString(words));
        const Result result = runProgram(words, "/dev/full");
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.err, "tread: cannot write the answer to standard output: No space left on device\n");
    }
}

}  // namespace
}  // namespace tread::output_test
