// Logs of others, not part of this repository: TREAD_SHARED_DATA names a folder of them. The shipped mappings turn each
// into a log whose channels fit one another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "base/yaml/read.h"
#include "import/import.h"
#include "places/places.h"
#include "recording/checks/rigid_body.h"
#include "recording/position.h"
#include "shared/import_problems.h"

namespace tread::import_shared_data_test {
namespace {

namespace fs = std::filesystem;
using recording::checks::InstrumentError;

class LogsOfOthers : public testing::Test {
protected:
    void SetUp() override {
        const char* const folder = std::getenv("TREAD_SHARED_DATA");
        if (!folder) GTEST_SKIP() << "TREAD_SHARED_DATA is not set";
        folder_ = folder;
    }

    Imported import(const std::string& file, const std::string& map, std::optional<double> rate = {}) const {
        SCOPED_TRACE(file);
        auto mapping = readYaml<ImportMap>(sourceFile("tools/import/" + map + ".yaml"));
        mapping.repairs.rate = rate;
        Imported result = importLog(readForeignTable(folder_ / file), mapping);
        EXPECT_EQ(result.logs.size(), 1u);
        return result;
    }

    fs::path folder_;
};

// Pearson's coefficient over the samples at which the car moves.
double correlation(const Log& log, const std::vector<double>& a, const std::vector<double>& b) {
    const std::vector<double>& vx = valuesOf(log, "chassis.vx");
    double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (vx[i] < 3) continue;
        n += 1, sa += a[i], sb += b[i], saa += a[i] * a[i], sbb += b[i] * b[i], sab += a[i] * b[i];
    }
    return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

// In a turn ay is vx times the yaw rate, whatever the car; and it turns to the side to which it is steered.
void expectCar(const Log& log, double least) {
    const std::vector<double>&vx = valuesOf(log, "chassis.vx"), &rate = valuesOf(log, "chassis.yaw_rate");
    std::vector<double> turn;
    for (std::size_t i = 0; i < vx.size(); ++i) turn.push_back(vx[i] * rate[i]);
    EXPECT_GT(correlation(log, turn, valuesOf(log, "chassis.ay")), least);
    EXPECT_GT(correlation(log, valuesOf(log, "driver.steering_wheel_angle"), rate), 0.7);
}

std::size_t doubtsIn(const Imported& result) {
    std::size_t doubts = 0;
    for (const Change& change : result.changes) doubts += change.kind == "doubt" || change.kind == "spikes";
    return doubts;
}

TEST_F(LogsOfOthers, Liu) {
    for (const char* file : {"liu/liu_dlc1.csv", "liu/liu_dlc2.csv", "liu/liu_rampsteer.csv"}) {
        const Imported result = import(file, "liu");
        expectCar(result.logs[0], 0.95);
        EXPECT_EQ(doubtsIn(result), 0u) << text(result.changes);
    }
    const Log circle = import("liu/liu_steady_state_R27_75.csv", "liu_steady_state").logs[0];
    EXPECT_NEAR(valuesOf(circle, "time")[250], 1, 1e-9);
    const std::vector<double>&vx = valuesOf(circle, "chassis.vx"), &rate = valuesOf(circle, "chassis.yaw_rate");
    for (std::size_t i = 0; i < vx.size(); i += 1000) EXPECT_NEAR(vx[i] / rate[i], 27.75, 1.5) << "the circle's radius";
}

TEST_F(LogsOfOthers, S90) {
    for (const char* file : {"s90/slalom_30.csv", "s90/sweep_50_70.csv"}) {
        const Imported result = import(file, "s90_csv");
        expectCar(result.logs[0], 0.95);
        EXPECT_EQ(doubtsIn(result), 0u) << text(result.changes);
    }
    const Imported still = import("s90/standstill.csv", "s90_csv");
    EXPECT_EQ(doubtsIn(still), 0u);
    EXPECT_LT(std::abs(valuesOf(still.logs[0], "chassis.vx")[1000]), 0.05);
}

// The same drive twice: as the raw .vbo and as the table that others made of it.
TEST_F(LogsOfOthers, S90RawFileSaysTheSameAsItsTable) {
    const Imported raw = import("s90/slalom_30.vbo", "s90_vbo");
    const Log& vbo = raw.logs[0];
    const Log csv = import("s90/slalom_30.csv", "s90_csv").logs[0];
    EXPECT_NE(text(raw.changes).find("time jumps by +6.14 s"), std::string::npos);
    ASSERT_GE(vbo.samples(), csv.samples());
    ASSERT_EQ(vbo.channels.size(), csv.channels.size());
    for (const Channel& channel : csv.channels) {
        const std::vector<double>& other = valuesOf(vbo, channel.name);
        double largest = 0, peak = 0;
        for (std::size_t i = 0; i < csv.samples(); ++i) {
            largest = std::max(largest, std::abs(channel.values[i] - other[i]));
            peak = std::max(peak, std::abs(channel.values[i]));
        }
        // The table took g as 9.81 m/s2, a standard one is 9.80665.
        EXPECT_LE(largest, 4e-4 * peak + 1e-6) << channel.name;
    }
}

TEST_F(LogsOfOthers, Tts) {
    for (const char* file : {"tts/oval_aa.csv", "tts/oval_ab.csv"}) {
        expectCar(import(file, "tts", 1).logs[0], 0.95);  // ay is noisy: means over a second
    }
}

TEST_F(LogsOfOthers, Chrono) {
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "chrono")) {
        if (entry.path().extension() != ".csv") continue;
        const Imported result = import(fs::relative(entry.path(), folder_), "chrono");
        EXPECT_EQ(doubtsIn(result), 0u) << entry.path() << text(result.changes);
        SCOPED_TRACE(entry.path());
        const std::string name = entry.path().filename();
        // With its load behind the rear axle the car spins after the largest step.
        const bool spins = name == "step_steer_080_s012.csv" && entry.path().parent_path().filename() == "case_c";
        if ((name.starts_with("step_steer") || name.starts_with("dlc")) && !spins) expectCar(result.logs[0], 0.9);
        ++files;
    }
    EXPECT_GE(files, 15u);
}

// The error of an instrument that explains how a channel differs from the others; nothing if there is none of that
// kind.
std::optional<double> errorOf(const Log& log, const std::string& channel, InstrumentError::Kind kind) {
    for (const auto& one : recording::checks::agreements(log, {})) {
        for (const InstrumentError& error : one.errors)
            if (one.channel == channel && error.kind == kind) return error.size;
    }
    return std::nullopt;
}

TEST_F(LogsOfOthers, S90HasTwoSetsOfInstrumentsAndTheCanIsLate) {
    const Log log = import("s90/sweep_50_70.csv", "s90_csv").logs[0];
    // Lags of 29 to 38 ms, depending on how they are estimated.
    EXPECT_NEAR(errorOf(log, "chassis.yaw_rate@can", InstrumentError::Kind::delay).value_or(0), 0.035, 0.01);
    EXPECT_NEAR(errorOf(log, "chassis.ax@can", InstrumentError::Kind::delay).value_or(0), 0.035, 0.01);
}

TEST_F(LogsOfOthers, LiuLateralVelocityContradictsItsAcceleration) {
    for (const char* file : {"liu/liu_dlc1.csv", "liu/liu_dlc2.csv", "liu/liu_rampsteer.csv"}) {
        const auto all = recording::checks::agreements(import(file, "liu").logs[0], {});
        ASSERT_EQ(all.size(), 1u);
        EXPECT_TRUE(all[0].contradicts) << toText(all[0]);
        EXPECT_GT(all[0].left, 0.4);
    }
}

TEST_F(LogsOfOthers, DartGyroIsLateAgainstMotionCapture) {
    for (const char* file : {"dart/rubber_floor/14_30_56_steer_03.csv", "dart/taped_floor/18_05_10_steer_03.csv"}) {
        Log log = import(file, "dart").logs[0];
        EXPECT_NE(valuesOf(log, "position.x")[0], 0) << "rows before the sensors send are cut";
        recording::addVelocities(log);
        const auto all = recording::checks::agreements(log, {});
        const auto gyro = std::find_if(all.begin(), all.end(), [](const auto& one) {
            return one.channel == "chassis.yaw_rate@position" && !one.errors.empty();
        });
        ASSERT_NE(gyro, all.end());
        EXPECT_EQ(gyro->errors[0].channel, "chassis.yaw_rate");
        EXPECT_NEAR(gyro->errors[0].size, 0.08, 0.03) << toText(*gyro);
    }
}

}  // namespace
}  // namespace tread::import_shared_data_test
