// Drivelines as a file describes them, and what it says of those that cannot be.

#include <gtest/gtest.h>

#include <string>

#include "base/yaml/read.h"
#include "base/yaml/write.h"
#include "tread/brakes.h"
#include "tread/driveline.h"

namespace tread::driveline_file_test {
namespace {

const std::string kEngine = R"(
engine:
  full_load: [[100, 100], [600, 120]]
  drag: [[0, 10], [600, 30]]
  inertia: 0.15
  idle_speed: 800 rpm
  speed_limit: 6500 rpm
)";
const std::string kClutch = "coupling: {clutch: {torque: 250 N m}}\n";
const std::string kGearbox = R"(
gearbox:
  ratios: [3.5, 2, 1.3]
  final_drive: 4
  inertia: 0.01
  shift_up_speed: 6000 rpm
  shift_down_speed: 1300 rpm
front_share: 1
)";

DrivelineParams read(const std::string& text) {
    return readYamlText<DrivelineParams>(text, "driveline.yaml");
}

// Everything that is wrong with a text, or "".
template <class T = DrivelineParams>
std::string fault(const std::string& text) {
    try {
        readYamlText<T>(text, "driveline.yaml");
        return "";
    } catch (const LoadError& error) {
        return error.what();
    }
}

TEST(DrivelineFile, DescribesAnElectricCar) {
    const DrivelineParams p = read(R"(
motor: {torque: 250 N m, power: 100 kW, speed_limit: 14000 rpm, inertia: 0.06, brake_regeneration: 60 %}
gearbox: {ratios: [1], final_drive: 9, inertia: 0.005}
front_share: 1
)");
    EXPECT_FALSE(p.engine);
    EXPECT_EQ(p.motor->power, 1e5);
    EXPECT_EQ(p.motor->brake_regeneration, 0.6);
}

TEST(DrivelineFile, DescribesConverterMapAndDifferentials) {
    const DrivelineParams p = read(kEngine + R"(
  part_load:
    - {throttle: 0.2, torque: [[100, 40], [600, -10]]}
    - {throttle: 0.6, torque: [[100, 80], [600, 60]]}
coupling:
  torque_converter: {capacity: [[0, 0.003], [1, 0]], torque_ratio: [[0, 2], [0.9, 1]], lock_up_gear: 3}
front_differential: {limited_slip: {preload: 50 N m, locking_driving: 30 %}}
rear_differential: {vectoring: {by_lateral_acceleration: 40, largest: 400 N m}}
centre_differential: locked
)" + kGearbox);
    EXPECT_EQ(p.engine->part_load[1].torque(600), 60);
    EXPECT_EQ(std::get<TorqueConverterParams>(p.coupling).lock_up_gear, 3);
    EXPECT_EQ(std::get<LimitedSlipDifferential>(p.front_differential).locking_driving, 0.3);
    EXPECT_EQ(std::get<VectoringDifferential>(p.rear_differential).largest, 400);
    EXPECT_TRUE(std::holds_alternative<LockedDifferential>(p.centre_differential));
    EXPECT_EQ(writeYaml(read(writeYaml(p))), writeYaml(p));
}

TEST(DrivelineFile, WithoutAnythingThatDrivesIsAnError) {
    EXPECT_NE(fault(kGearbox).find("found neither engine nor motor"), std::string::npos) << fault(kGearbox);
}

TEST(DrivelineFile, EngineWithoutClutchIsAnError) {
    EXPECT_NE(fault(kEngine + kGearbox).find("coupling"), std::string::npos);
    EXPECT_EQ(fault(kEngine + kClutch + kGearbox), "");
}

TEST(DrivelineFile, SeveralGearsNeedTheirShiftSpeeds) {
    const std::string text =
        kEngine + kClutch + "gearbox: {ratios: [3, 2], final_drive: 4, inertia: 0.01}\nfront_share: 1\n";
    EXPECT_NE(fault(text).find("shift_up_speed"), std::string::npos);
    EXPECT_NE(fault(text).find("shift_down_speed"), std::string::npos) << fault(text);
}

TEST(DrivelineFile, ShiftMapThatHuntsIsAnError) {
    std::string gearbox = kGearbox;
    gearbox.replace(gearbox.find("1300 rpm"), 8, "2000 rpm");
    EXPECT_NE(fault(kEngine + kClutch + gearbox).find("up and down without end"), std::string::npos);
}

TEST(DrivelineFile, RatiosThatDoNotFallAreAnError) {
    std::string gearbox = kGearbox;
    gearbox.replace(gearbox.find("[3.5, 2, 1.3]"), 13, "[3.5, 2, 2.0]");
    EXPECT_NE(fault(kEngine + kClutch + gearbox).find("smaller than that of the gear before"), std::string::npos);
}

TEST(DrivelineFile, ConverterThatNeverStopsTransmittingIsAnError) {
    const std::string converter =
        "coupling: {torque_converter: {capacity: [[0, 0.003], [1, 0.001]], torque_ratio: [[0, 2], [0.9, 1.1]]}}\n";
    const std::string all = fault(kEngine + converter + kGearbox);
    EXPECT_NE(all.find("[1, 0]"), std::string::npos);
    EXPECT_NE(all.find("torque_ratio"), std::string::npos);
}

TEST(DrivelineFile, PartLoadThatDoesNotRiseIsAnError) {
    const std::string rows = "  part_load: [{throttle: 0.5, torque: [[0, 40]]}, {throttle: 0.5, torque: [[0, 50]]}]\n";
    EXPECT_NE(fault(kEngine + rows + kClutch + kGearbox).find("larger than that of the one before"), std::string::npos);
}

TEST(BrakesFile, AntiLockThatBuildsAboveWhereItDumpsIsAnError) {
    const std::string text = "full_pedal_torque: 5000\nfront_share: 0.7\nanti_lock: {enabled: true, build_slip: 0.2}\n";
    EXPECT_NE(fault<BrakeParams>(text).find("build_slip"), std::string::npos) << fault<BrakeParams>(text);
}

}  // namespace
}  // namespace tread::driveline_file_test
