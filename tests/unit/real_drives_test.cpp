// Drives of real cars, not part of this repository: TREAD_SHARED_DATA names a folder of them. The shipped cars that
// bear their published numbers do what was measured when steering wheel and speed are repeated.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/yaml/read.h"
#include "compare/compare.h"
#include "import/import.h"
#include "log/csv.h"
#include "places/places.h"
#include "run/simulate.h"
#include "scenario/load.h"
#include "scenario/replay.h"
#include "shared/scratch.h"
#include "tread/load.h"

namespace tread::real_drives_test {
namespace {

struct Drive {
    const char* file;
    const char* map;
    const char* car;
    const char* scenario;
    const char* lateral;    // channel of the lateral acceleration
    double least_yaw_rate;  // R2
    double least_lateral;
};

std::ostream& operator<<(std::ostream& out, const Drive& drive) {
    return out << drive.file;
}

class RealDrive : public testing::TestWithParam<Drive> {
protected:
    void SetUp() override {
        const char* const folder = std::getenv("TREAD_SHARED_DATA");
        if (!folder) GTEST_SKIP() << "TREAD_SHARED_DATA is not set";
        folder_ = folder;
    }
    std::filesystem::path folder_;
};

TEST_P(RealDrive, IsRepeated) {
    const Drive& drive = GetParam();
    const auto map = readYaml<ImportMap>(sourceFile(std::string("tools/import/") + drive.map + ".yaml"));
    const Log measured = importLog(readForeignTable(folder_ / drive.file), map).logs.at(0);
    const Scratch scratch;
    writeLog(scratch.path("drive.csv"), measured);

    Scenario scenario = loadScenario(sourceFile(std::string("scenarios/replay/") + drive.scenario + ".yaml"));
    scenario.drive = scratch.path("drive.csv");
    scenario.log.channels = {"chassis.*"};
    const Log simulated =
        simulate(loadVehicle(sourceFile(std::string("vehicles/") + drive.car + ".yaml")), withReplaysRead(scenario));

    const auto likeness = [&, all = compare(measured, simulated)](const std::string& name) {
        for (const ChannelComparison& channel : all.channels) {
            if (channel.channel != name) continue;
            std::printf("%-38s %-18s R2 %.4f  RMS %.4f %s\n", drive.file, name.c_str(), channel.r_squared.value_or(0),
                        channel.rms, channel.unit.c_str());
            return channel.r_squared.value_or(0);
        }
        return 0.0;
    };
    EXPECT_GT(likeness("chassis.vx"), 0.8) << "the driver keeps to the speed";
    EXPECT_GT(likeness("chassis.yaw_rate"), drive.least_yaw_rate);
    EXPECT_GT(likeness(drive.lateral), drive.least_lateral);
}

// The least is what was measured, less a margin; and it lies above what a linear single-track model reaches that was
// fitted to the same drives.
INSTANTIATE_TEST_SUITE_P(
    , RealDrive,
    testing::Values(Drive{"liu/liu_dlc1.csv", "liu", "liu_compact", "drive", "chassis.ay", 0.9975, 0.993},
                    Drive{"liu/liu_dlc2.csv", "liu", "liu_compact", "drive", "chassis.ay", 0.998, 0.993},
                    Drive{"liu/liu_rampsteer.csv", "liu", "liu_compact", "drive", "chassis.ay", 0.995, 0.985},
                    Drive{"s90/slalom_30.csv", "s90_csv", "volvo_s90", "volvo_s90", "sensor.vbox_ay", 0.998, 0.972},
                    Drive{"s90/slalom_30.vbo", "s90_vbo", "volvo_s90", "volvo_s90", "sensor.vbox_ay", 0.998, 0.972},
                    Drive{"s90/sweep_50_70.csv", "s90_csv", "volvo_s90", "volvo_s90", "sensor.vbox_ay", 0.99, 0.975}),
    [](const testing::TestParamInfo<Drive>& drive) {
        std::string name = std::filesystem::path(drive.param.file).filename();
        for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
        return name;
    });

}  // namespace
}  // namespace tread::real_drives_test
