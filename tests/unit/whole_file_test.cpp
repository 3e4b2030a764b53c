#include "store/whole_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>

#include "shared/scratch.h"

namespace tread::whole_file_test {
namespace {

std::string thisMachine() {
    char host[65] = "";
    gethostname(host, sizeof host - 1);
    return host;
}

// Temporary files of processes that have ended; the third number only makes the names unique.
struct Leftovers {
    Scratch scratch;

    std::string leave(const std::string& host, std::chrono::minutes age) {
        const std::string file =
            scratch.file("log.csv." + host + ".12." + std::to_string(count++) + ".tread.part", "x");
        std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now() - age);
        return file;
    }

    int count = 0;
};

TEST(WholeFile, LeftoversOfThisMachineAreRemovedAtOnce) {
    Leftovers folder;
    folder.leave(thisMachine(), std::chrono::minutes(0));
    removeLeftovers(folder.scratch.folder());
    EXPECT_TRUE(folder.scratch.names().empty());
}

// A lock of another machine may not be seen here: its file may still be in the making.
TEST(WholeFile, LeftoversOfAnotherMachineStayForAnHour) {
    Leftovers folder;
    const std::string recent = folder.leave("another-machine", std::chrono::minutes(50));
    const std::string old = folder.leave("another-machine", std::chrono::minutes(70));
    removeLeftovers(folder.scratch.folder());
    EXPECT_TRUE(std::filesystem::exists(recent));
    EXPECT_FALSE(std::filesystem::exists(old));
}

TEST(WholeFile, FilesOfOthersAreNoLeftovers) {
    const Scratch scratch;
    for (const char* name : {"log.csv.tread.part", "log.csv.host.x.0.tread.part", "log.csv", "a.b.c.part"})
        scratch.file(name, "x");
    removeLeftovers(scratch.folder());
    EXPECT_EQ(scratch.names().size(), 4u);
}

}  // namespace
}  // namespace tread::whole_file_test
