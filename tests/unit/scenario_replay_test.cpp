#include "scenario/replay.h"

#include <gtest/gtest.h>

#include "base/yaml/read.h"
#include "log/csv.h"
#include "scenario/driver.h"
#include "scenario/load.h"
#include "shared/scratch.h"

namespace tread::scenario_replay_test {
namespace {

constexpr const char* kLog =
    "time [s],driver.steering_wheel_angle [rad],driver.brake [-],chassis.vx [m/s]\n"
    "0,0,0,20\n1,0.5,0.002,20\n2,0.5,-0.001,20\n3,-0.5,0.6,20\n";

class ScenarioReplay : public testing::Test {
protected:
    void SetUp() override { scratch.file("drive.csv", kLog); }

    Scenario scenario(const std::string& phase) {
        return loadScenario(scratch.file("scenario.yaml", "phases:\n  - {" + phase + ", until: {duration: 5}}\n"));
    }
    std::string faultOf(const std::string& phase) {
        try {
            Driver driver(scenario(phase), {});
        } catch (const LoadError& error) {
            return error.what();
        }
        return "no fault";
    }
    const Scratch scratch;
};

TEST_F(ScenarioReplay, HandAndFootDoWhatTheLogSays) {
    const Scenario read = scenario(
        "steering: {replay: {file: drive.csv, channel: driver.steering_wheel_angle, from: 0.5}}, "
        "brake: {replay: {file: drive.csv, channel: driver.brake}}");
    Driver driver(read, {});
    driver.look(0, {});
    EXPECT_DOUBLE_EQ(driver.inputAt(0.25).steering_wheel_angle, 0.375);
    EXPECT_DOUBLE_EQ(driver.inputAt(1).brake, 0.002);
    EXPECT_DOUBLE_EQ(driver.inputAt(2).brake, 0) << "noise below zero is no negative pedal";
    EXPECT_DOUBLE_EQ(driver.inputAt(2.5).steering_wheel_angle, -0.5);
    EXPECT_DOUBLE_EQ(driver.inputAt(4).steering_wheel_angle, -0.5) << "held behind the end";
}

TEST_F(ScenarioReplay, ChannelThatIsNotThereIsAFault) {
    EXPECT_NE(faultOf("brake: {replay: {file: drive.csv, channel: driver.brakes}}")
                  .find("drive.csv: phases.0.brake.replay.channel: found \"driver.brakes\", which the log does not "
                        "have; did you mean \"driver.brake\"?"),
              std::string::npos);
}

TEST_F(ScenarioReplay, ChannelOfAnotherUnitIsAFault) {
    EXPECT_NE(faultOf("steering: {replay: {file: drive.csv, channel: chassis.vx}}")
                  .find("found \"chassis.vx [m/s]\", expected a channel in rad"),
              std::string::npos);
}

TEST_F(ScenarioReplay, BeginningBehindTheEndOfTheLogIsAFault) {
    EXPECT_NE(faultOf("brake: {replay: {file: drive.csv, channel: driver.brake, from: 3}}")
                  .find("replay.from: found 3 s, which is after the end of the log"),
              std::string::npos);
}

TEST_F(ScenarioReplay, MissingFileOrNameIsAFault) {
    EXPECT_THROW(Driver(scenario("brake: {replay: {file: none.csv, channel: driver.brake}}"), {}), std::runtime_error);
    EXPECT_THROW(scenario("brake: {replay: {file: drive.csv}}"), LoadError);
    EXPECT_THROW(Driver(scenario("brake: {replay: {channel: driver.brake}}"), {}), LoadError) << "no drive either";
}

constexpr const char* kRepeat =
    "phases:\n"
    "  - steering: {replay: {channel: driver.steering_wheel_angle}}\n"
    "    throttle: {hold_speed: {as_driven: true}}\n"
    "    until: {drive_end: true}\n";

TEST_F(ScenarioReplay, DriveGivesHandSpeedAndEnd) {
    const Scenario asked = loadScenario(scratch.file("scenario.yaml", std::string("drive: drive.csv\n") + kRepeat));
    const Scenario read = withReplaysRead(asked);
    EXPECT_DOUBLE_EQ(read.start.speed, 20);
    EXPECT_DOUBLE_EQ(std::get<Table<Angle>>(read.phases[0].steering).points(0.5), 0.25);
    EXPECT_DOUBLE_EQ(std::get<HoldSpeed>(read.phases[0].throttle).profile(3), 20);
    EXPECT_DOUBLE_EQ(read.phases[0].until.time.value(), 3);
    EXPECT_EQ(read.drive, "") << "read once: the scenario that is kept with the run needs the log no more";
    EXPECT_DOUBLE_EQ(withReplaysRead(read).phases[0].until.time.value(), 3);
}

TEST_F(ScenarioReplay, OwnStartSpeedWins) {
    const Scenario asked =
        loadScenario(scratch.file("scenario.yaml", std::string("drive: drive.csv\nstart: {speed: 5}\n") + kRepeat));
    EXPECT_DOUBLE_EQ(withReplaysRead(asked).start.speed, 5);
}

TEST_F(ScenarioReplay, DriveThatIsNotNamedOrNotRepeatedIsAFault) {
    const auto fault = [&](const std::string& text) -> std::string {
        try {
            withReplaysRead(loadScenario(scratch.file("scenario.yaml", text)));
        } catch (const LoadError& error) {
            return error.what();
        }
        return "no fault";
    };
    EXPECT_EQ(fault(kRepeat),
              "scenario.drive: found no log of the drive that the scenario repeats; name it here, or with `tread run "
              "--log FILE`");
    EXPECT_NE(fault("drive: drive.csv\nphases: [{until: {duration: 5}}]").find("but nothing that repeats it"),
              std::string::npos);
}

}  // namespace
}  // namespace tread::scenario_replay_test
