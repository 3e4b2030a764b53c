// The demo of a host in C: both of its modes drive the same.
#include <gtest/gtest.h>

#include "program.h"

namespace tread::c_host_test {
namespace {

Result runHost(const std::string& car, const std::string& mode) {
    const std::filesystem::path host = std::filesystem::path(programFile()).replace_filename("c_host");
    return runOther(host.string(), {car, mode});
}

TEST(CHost, ItsOwnBodyDrivesOverItsTerrainAsTreadsChassisDoes) {
    const Scratch scratch;
    const std::string car = sourceFile("vehicles/compact.yaml");
    std::string files[2];
    for (const std::string mode : {"own", "body"}) {
        const Result result = runHost(car, mode);
        ASSERT_EQ(result.status, 0) << result.err;
        files[mode == "body"] = scratch.file(mode + ".csv", result.out);
    }
    const Result compared = runProgram({"compare", files[0], files[1], "--json"});
    EXPECT_EQ(compared.status, 0) << compared.out;
    EXPECT_NE(contentOf(files[0]), contentOf(files[1])) << "two ways";
}

TEST(CHost, SaysWhatIsWrongWithACar) {
    const Result result = runHost("no_such.yaml", "own");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("no_such.yaml"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace tread::c_host_test
