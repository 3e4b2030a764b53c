// Recorded commands as inputs of a replay, and drives whose speed is followed before the pedals act.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "recording/driver_inputs.h"
#include "recording/replay.h"
#include "recording/sliding.h"

namespace tread::command_replay_test {
namespace {

using namespace recording;

constexpr double kSample = 0.01;  // s
constexpr double kMass = 1500;    // kg

using Signal = std::function<double(double time)>;

// Ten seconds of these channels.
Log recorded(const std::vector<std::tuple<std::string, std::string, Signal>>& channels) {
    Log log{{{"time", "s", {}}}};
    for (const auto& [name, unit, signal] : channels) log.channels.push_back({name, unit, {}});
    for (int i = 0; i <= 1000; ++i) {
        const double t = kSample * i;
        log.channels[0].values.push_back(t);
        for (std::size_t k = 0; k < channels.size(); ++k)
            log.channels[k + 1].values.push_back(std::get<Signal>(channels[k])(t));
    }
    return log;
}

const Signal kSteady = [](double) { return 20.0; };
const Signal kRamps = [](double t) { return t < 2 ? 0.0 : t < 4 ? 1000 * (t - 2) : 2000; };  // N
const Signal kNone = [](double) { return 0.0; };

const Recording kCommanded{.log = "a.csv", .speed = SpeedReplay::command};

Log commanded(const std::string& channel, double scale) {
    return recorded({{channel, "N", [=](double t) { return scale * kRamps(t); }},
                     {"chassis.vx", "m/s", kSteady},
                     {"chassis.ax", "m/s2", kNone}});
}

RecordedDrive drive(const Recording& recording, const Log& log) {
    return recordedDrive(recording, log, {});
}

Curve forceOf(const RecordedDrive& drive, const ForceActuator& actuator) {
    return commandedForce(drive, actuator, kMass);
}

TEST(CommandedForce, IsTheRecordedOneThroughANeutralActuator) {
    const RecordedDrive as_force = drive(kCommanded, commanded("command.force", 1));
    const RecordedDrive as_acceleration = drive(kCommanded, commanded("command.acceleration", 1 / kMass));
    for (const double t : {0.0, 1.5, 2.5, 3.7, 9.0}) {
        EXPECT_NEAR(forceOf(as_force, {})(t), kRamps(t), 1e-6) << t;
        EXPECT_NEAR(forceOf(as_acceleration, {})(t), kRamps(t), 1e-6) << t;
    }
}

TEST(CommandedForce, ActuatorScalesShiftsAndDelaysIt) {
    const RecordedDrive car = drive(kCommanded, commanded("command.force", 1));
    for (const double t : {0.0, 2.5, 3.7, 9.0})
        EXPECT_NEAR(forceOf(car, {.gain = 1.1, .bias = -50, .delay = 0.07})(t), 1.1 * kRamps(t - 0.07) - 50, 1e-6);
}

TEST(CommandedForce, LagFollowsARampAtADistanceOfTheTimeConstant) {
    const RecordedDrive car = drive(kCommanded, commanded("command.force", 1));
    const Curve force = forceOf(car, {.lag = 0.1});
    const auto ramp = [](double since) { return 1000 * (since - 0.1 * (1 - std::exp(-since / 0.1))); };
    for (const double since : {0.05, 0.1, 0.3, 1.9}) EXPECT_NEAR(force(2 + since), ramp(since), 1e-6) << since;
    EXPECT_NEAR(force(4.1), 2000 - 100 * std::exp(-1), 0.01);
    EXPECT_NEAR(force(1.9), 0, 1e-9);
}

TEST(CommandedForce, IsTheInputOfTheReplay) {
    const RecordedDrive car = drive(kCommanded, commanded("command.force", 1));
    Subject nominal;
    nominal.vehicle.mass = kMass;
    Subject subject = nominal;
    subject.instruments.command.gain = 0.9;
    subject.vehicle.mass = 1800;
    const Scenario scenario = replayOf(car, subject, {nominal, 0.004, {}});
    const auto* command = std::get_if<tread::CommandedForce>(&scenario.phases.front().throttle);
    ASSERT_TRUE(command);
    EXPECT_NEAR(command->points(3), 900, 1e-6);
    EXPECT_EQ(car.channels.size(), 2u) << "speed and acceleration are compared";
}

std::string faultOf(const Recording& recording, const Log& log, const DiagnosisFile& file = {}) {
    try {
        recordedDrive(recording, log, file);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

TEST(CommandedForce, MissingOneIsSaid) {
    EXPECT_EQ(faultOf(kCommanded, recorded({{"chassis.vx", "m/s", kSteady}})),
              "recording a.csv: found neither command.force nor command.acceleration, expected one of them for speed: "
              "command; name its column (import, channels) or set speed: followed");
}

TEST(CommandedForce, WithoutAMeasuredAnswerIsSaid) {
    DiagnosisFile file;
    file.channels = {{.channel = "chassis.yaw_rate"}};
    const Log log = recorded(
        {{"command.force", "N", kRamps}, {"chassis.vx", "m/s", kSteady}, {"chassis.yaw_rate", "rad/s", kNone}});
    EXPECT_EQ(
        faultOf(kCommanded, log, file),
        "recording a.csv: found command.force but no measured speed or longitudinal acceleration to compare with, "
        "expected chassis.vx or chassis.ax among the channels; measure one of them or set speed: followed");
}

// ---- Drives that start faster ----

const FollowSpeed& followedFirst(const Scenario& scenario) {
    return std::get<FollowSpeed>(scenario.phases.front().throttle);
}

TEST(FasterStart, IsReachedBeforeADriveThatBeginsInATurn) {
    Log log = commanded("command.force", 1);
    log.channels.push_back({"chassis.yaw_rate", "rad/s", std::vector<double>(log.samples(), 0.2)});
    const RecordedDrive car = drive(kCommanded, log);
    const Scenario recorded = replayOf(car, {}, {{}, 0.004, {}}), faster = replayOf(car, {}, {{}, 0.004, {}, 0.5});
    ASSERT_EQ(faster.phases.size(), 2u) << "into the turn, and the drive";
    EXPECT_NEAR(faster.start.speed, recorded.start.speed + 0.5, 1e-12);
    EXPECT_NEAR(followedFirst(faster).profile(1), followedFirst(recorded).profile(1) + 0.5, 1e-12);
}

// ---- Pedals after a time in which the speed is followed ----

Log pedalled() {
    return recorded({{"driver.steering_wheel_angle", "rad", [](double t) { return 0.01 * t; }},
                     {"driver.throttle", "-", [](double t) { return t < 1.5 ? 0.4 : 0.0; }},
                     {"driver.brake", "-", [](double t) { return t < 2 ? 0.0 : 0.3; }},
                     {"chassis.vx", "m/s", [](double t) { return 20 - std::max(0.0, t - 1.5); }},
                     {"chassis.ay", "m/s2", kNone},
                     {"chassis.yaw_rate", "rad/s", kNone}});
}

TEST(FollowedFor, ThePedalsActAfterIt) {
    const Recording recording{.log = "a.csv", .followed_for = 1.5};
    const Scenario scenario = replayOf(drive(recording, pedalled()), {}, {{}, 0.004, {}});
    ASSERT_EQ(scenario.phases.size(), 2u);
    const Phase &first = scenario.phases[0], &second = scenario.phases[1];
    EXPECT_NEAR(*first.until.duration, 1.5, 1e-12);
    EXPECT_NEAR(*second.until.duration, 8.5, 1e-12);
    ASSERT_TRUE(std::holds_alternative<FollowSpeed>(first.throttle));
    EXPECT_TRUE(std::holds_alternative<Keep>(first.brake));
    EXPECT_NEAR(std::get<Table<Angle>>(first.steering).points(1), 0.01, 1e-6);
    EXPECT_NEAR(std::get<Table<Angle>>(second.steering).points(1), 0.025, 1e-6);
    EXPECT_NEAR(std::get<Table<Pedal>>(second.throttle).points(0.1), 0, 1e-6);
    EXPECT_NEAR(std::get<Table<Pedal>>(second.brake).points(1), 0.3, 1e-6);
}

TEST(FasterStart, IsThatOfThePartInWhichThePedalsAct) {
    const Recording recording{.log = "a.csv", .followed_for = 1.5};
    const RecordedDrive car = drive(recording, pedalled());
    const Scenario recorded = replayOf(car, {}, {{}, 0.004, {}}), faster = replayOf(car, {}, {{}, 0.004, {}, 0.5});
    for (const double t : {0.0, 1.5})
        EXPECT_NEAR(followedFirst(faster).profile(t), followedFirst(recorded).profile(t) + 0.5, 1e-12) << t;
}

TEST(FasterStart, IsNoneWhereTheSpeedIsFollowedThroughout) {
    for (const Recording& recording :
         {Recording{.log = "a.csv", .speed = SpeedReplay::followed}, Recording{.log = "a.csv", .followed_for = 20}}) {
        const RecordedDrive car = drive(recording, pedalled());
        const Scenario recorded = replayOf(car, {}, {{}, 0.004, {}}), faster = replayOf(car, {}, {{}, 0.004, {}, 0.5});
        EXPECT_EQ(faster.start.speed, recorded.start.speed);
        EXPECT_EQ(followedFirst(faster).profile(1), followedFirst(recorded).profile(1));
    }
}

TEST(FasterStart, OfAStandingCarIsNone) {
    Log log = pedalled();
    for (Channel& channel : log.channels)
        if (channel.name == "chassis.vx") std::fill(channel.values.begin(), channel.values.end(), 0.0);
    EXPECT_EQ(replayOf(drive({.log = "a.csv"}, log), {}, {{}, 0.004, {}, 0.5}).start.speed, 0);
}

TEST(FollowedFor, SpeedIsComparedAfterItOnly) {
    const Recording recording{.log = "a.csv", .followed_for = 1.5};
    const RecordedDrive car = drive(recording, pedalled());
    for (const ObservedChannel& channel : car.channels)
        EXPECT_NEAR(channel.times.front(), channel.name == "chassis.vx" ? 1.525 : 0.025, 1e-9) << channel.name;
}

TEST(FollowedFor, ASlideIsStillSeen) {
    const Recording recording{.log = "a.csv", .followed_for = 1.5};
    const RecordedDrive car = drive(recording, pedalled());
    Eigen::VectorXd model = car.measured;
    EXPECT_EQ(slideApart(car, model), kInfinity);
    const ObservedChannel& yaw_rate = car.channels.back();
    ASSERT_EQ(yaw_rate.name, "chassis.yaw_rate");
    for (Eigen::Index i = 0; i < yaw_rate.rows(); ++i)
        if (yaw_rate.times[static_cast<std::size_t>(i)] > 5) model(yaw_rate.first_row + i) += 0.2;
    EXPECT_NEAR(slideApart(car, model), 5 + 0.4 - 1.5, 0.1);
}

}  // namespace
}  // namespace tread::command_replay_test
