// A log that is cut in the middle of a turn is followed from its beginning on; one that begins straight needs no
// run-in.
#include "scenario/run_in.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "log/csv.h"
#include "scenario/replay.h"
#include "shared/scratch.h"
#include "shared/vehicle_run.h"

namespace tread::run_in_test {
namespace {

using shared::channel;

constexpr const char* kRepeat =
    "drive: drive.csv\n"
    "phases:\n"
    "  - steering: {replay: {channel: driver.steering_wheel_angle}}\n"
    "    throttle: {hold_speed: {as_driven: true, proportional: 0.8, integral: 0.5}}\n"
    "    until: {drive_end: true}\n";

// A weave at 20 m/s into a turn to the left, at 100 rows per second.
Log weave() {
    Scenario scenario;
    scenario.start.speed = 20;
    Phase& phase = scenario.phases.emplace_back();
    phase.steering = Table<Angle>{Curve{{{1, 0}, {2, 0.7}, {6, 0.7}, {7, 0.4}, {8, 0.7}, {9, 0.5}}}};
    phase.throttle = HoldSpeed{};
    phase.until.duration = 10;
    return simulate(shared::compact(), scenario);
}

Log cut(Log log, double from) {
    const std::vector<double> time = channel(log, "time");
    const auto skipped = std::lower_bound(time.begin(), time.end(), from - 1e-9) - time.begin();
    for (Channel& one : log.channels) one.values.erase(one.values.begin(), one.values.begin() + skipped);
    for (double& t : log.channels.front().values) t -= from;
    return log;
}

class RunIn : public testing::Test {
protected:
    Scenario repeating(const Log& drive) const {
        writeLog(scratch.path("drive.csv"), drive);
        return withReplaysRead(loadScenario(scratch.file("scenario.yaml", kRepeat)));
    }
    const Scratch scratch;
};

TEST_F(RunIn, LogThatBeginsInATurnIsFollowedFromItsBeginningOn) {
    const Log drive = cut(weave(), 5.5);
    ASSERT_GT(channel(drive, "chassis.yaw_rate").front(), 0.15) << "a drive in a turn";
    const Log replay = simulate(shared::compact(), repeating(drive));
    ASSERT_EQ(channel(replay, "time").front(), 0);
    EXPECT_NEAR(channel(replay, "time").back(), channel(drive, "time").back(), 0.002);
    for (double t = 0; t <= 4.4; t += 0.1) {
        for (const char* name : {"chassis.yaw_rate", "chassis.ay", "chassis.vx"}) {
            const double driven = shared::valueAt(drive, name, t);
            EXPECT_NEAR(shared::valueAt(replay, name, t), driven, 0.03 * std::abs(driven)) << name << " at " << t;
        }
        EXPECT_NEAR(shared::valueAt(replay, "chassis.roll", t), shared::valueAt(drive, "chassis.roll", t), 0.001);
    }
}

TEST_F(RunIn, LogThatBeginsStraightHasNone) {
    const Scenario scenario = repeating(weave());
    EXPECT_EQ(scenario.start.run_in, 0);
    EXPECT_EQ(scenario.phases.size(), 1u);
}

TEST_F(RunIn, IsAddedOnce) {
    const Scenario once = repeating(cut(weave(), 5.5));
    EXPECT_EQ(once.phases.size(), 2u);
    EXPECT_EQ(withReplaysRead(once).phases.size(), 2u);
    EXPECT_GT(once.start.run_in, 0);
}

TEST(BeginsInTurn, ParkedCarOrGapInTheLogIsNoTurn) {
    const std::vector<double> time{0, 0.05, 0.5}, turning{0.2, 0.2, 0.2}, later{0, 0, 0.2}, gap(3, std::nan(""));
    EXPECT_TRUE(beginsInTurn(10, time, turning));
    EXPECT_FALSE(beginsInTurn(10, time, later));
    EXPECT_FALSE(beginsInTurn(10, time, gap));
    EXPECT_FALSE(beginsInTurn(0, time, turning));
}

}  // namespace
}  // namespace tread::run_in_test
