// A drive is logged, repeated from its log and compared: what a user does with a measurement.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/tread_run.h"

namespace tread::run_log_test {
namespace {

const std::string kCar = kSource + "/vehicles/compact.yaml";
const std::string kRepeat = kSource + "/scenarios/replay/drive.yaml";

TEST(RunLog, DriveIsRepeatedFromItsLog) {
    const Scratch scratch;
    const std::string drive = scratch.path("drive/log.csv");
    ASSERT_EQ(runProgram({"run", kCar, kSource + "/scenarios/step_steer_80.yaml", "-o", scratch.path("drive")}).status,
              0);
    const Result run = runProgram({"run", kCar, kRepeat, "--log", drive, "-o", scratch.path("again")});
    ASSERT_EQ(run.status, 0) << run.err;

    const Result compared = runProgram({"compare", drive, scratch.path("again/log.csv"), "--json"});
    ASSERT_EQ(compared.status, 1) << "the feet are not those of the drive";
    std::size_t found = 0;
    const auto comparison = nlohmann::json::parse(compared.out);
    for (const auto& channel : comparison["channels"]) {
        const std::string name = channel["channel"];
        if (name != "chassis.yaw_rate" && name != "chassis.ay" && name != "driver.steering_wheel_angle") continue;
        EXPECT_GT(channel["r_squared"].get<double>(), 0.999) << name;
        ++found;
    }
    EXPECT_EQ(found, 3u);
}

TEST(RunLog, LogThatIsMissingOrOfNoUseIsRefusedWithOneSentence) {
    const Scratch scratch;
    const Result none = runProgram({"run", kCar, kRepeat, "-o", scratch.path("a")});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("found no log of the drive that the scenario repeats"), std::string::npos) << none.err;
    const Result useless = runProgram({"run", kCar, kSource + "/scenarios/step_steer_80.yaml", "--log",
                                       scratch.path("drive.csv"), "-o", scratch.path("a")});
    EXPECT_EQ(useless.status, 2);
    EXPECT_NE(useless.err.find("nothing that repeats it"), std::string::npos) << useless.err;
}

}  // namespace
}  // namespace tread::run_log_test
