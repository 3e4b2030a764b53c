// Logs of others, not part of this repository: TREAD_SHARED_DATA names a folder of them. The shipped mappings turn each
// into a log whose channels fit one another.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "base/read_yaml.h"
#include "import/import.h"
#include "places/places.h"
#include "shared/import_problems.h"

namespace tread {
namespace {

namespace fs = std::filesystem;

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
        const std::string name = entry.path().filename();
        if (name.starts_with("step_steer") || name.starts_with("dlc")) expectCar(result.logs[0], 0.9);
        ++files;
    }
    EXPECT_GE(files, 15u);
}

}  // namespace
}  // namespace tread
