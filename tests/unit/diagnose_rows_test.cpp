// What the rows of a drive count for: their noise, what disturbs them, and where a drive ends that tells nothing more.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/math/random.h"
#include "diagnose/model/disturbance.h"
#include "diagnose/model/noise.h"
#include "diagnose/model/uncertainty.h"
#include "recording/checks/left_out.h"
#include "recording/diagnosis_file.h"
#include "recording/recorded_drive.h"
#include "recording/replay.h"
#include "recording/sliding.h"
#include "recording/subject.h"

namespace tread::diagnose_rows_test {
namespace {

using recording::kBlock;

using diagnose::model::Disturbances;
using diagnose::model::Disturbed;
using diagnose::model::endsOf;
using diagnose::model::hatsOver;
using diagnose::model::RowNoise;
using recording::RecordedDrive;
using recording::recordedDrive;
using recording::Recording;
using recording::replayOf;
using recording::slideApart;
using recording::SpeedReplay;
using recording::Subject;
using recording::checks::leftOut;

constexpr Eigen::Index kRows = 2000;

RowNoise noiseOf(double deviation) {
    return {.deviation = Eigen::VectorXd::Constant(kRows, deviation), .ends = {kRows}};
}

Eigen::VectorXd wave(double frequency) {
    Eigen::VectorXd rows(kRows);
    for (Eigen::Index i = 0; i < kRows; ++i)
        rows(i) = std::sin(2 * std::numbers::pi * frequency * kBlock * static_cast<double>(i));
    return rows;
}

double rms(const Eigen::MatrixXd& rows) {
    return std::sqrt(rows.squaredNorm() / static_cast<double>(rows.size()));
}

TEST(RowNoise, WhatIsSlowCountsInFullAndVibrationATenth) {
    const RowNoise noise = noiseOf(0.1);
    EXPECT_NEAR(rms(noise.over(wave(0.5))) / rms(wave(0.5)), 10.0, 0.1);
    EXPECT_NEAR(rms(noise.over(wave(8))) / rms(wave(8)), 0.95, 0.02) << "cos^2 of 72 degrees of what is slow";
}

TEST(RowNoise, ThreeEighthsOfWhiteNoiseAreLeft) {
    Random random(3);
    Eigen::VectorXd white(kRows);
    for (double& value : white) value = 0.1 * random.normal();
    EXPECT_NEAR(noiseOf(0.1).over(white).squaredNorm() / kRows, 0.375, 0.03);
}

TEST(RowNoise, ChannelsDoNotRunIntoEachOther) {
    RowNoise noise{.deviation = Eigen::VectorXd::Ones(6), .ends = {3, 6}};
    Eigen::VectorXd rows(6);
    rows << 1, 1, 1, 0, 0, 0;
    EXPECT_EQ(noise.over(rows), rows);
}

TEST(RowNoise, RowsThatSayNothingAreNothing) {
    RowNoise noise = noiseOf(1);
    noise.deviation.tail(100).setConstant(kInfinity);
    EXPECT_EQ(noise.over(wave(1)).bottomRows(99).norm(), 0);
}

TEST(Disturbances, HatsAreCorrelatedAsTheProcessIs) {
    // Ornstein-Uhlenbeck processes of a quarter of a second, seen every quarter or eighth.
    const Disturbances disturbing{
        .columns = {}, .kinds = {}, .times = {}, .hats = hatsOver(2.4, diagnose::model::Resolution::fine)};
    Eigen::Index first = 0;
    for (const Disturbed kind : diagnose::model::kDisturbedKinds) {
        const diagnose::model::Hats& hats = disturbing.of(kind);
        const bool slow = kind == Disturbed::longitudinal || kind == Disturbed::steering;
        EXPECT_EQ(hats.apart, slow ? 0.25 : 0.125) << nameOf(kind);
        EXPECT_EQ(hats.count(), slow ? 11 : 21) << "the last is not before the end";
        EXPECT_EQ(hats.first, first);
        const Eigen::MatrixXd covariance = hats.correlation_factor * hats.correlation_factor.transpose();
        for (Eigen::Index i = 0; i < hats.count(); ++i) {
            for (Eigen::Index j = 0; j < hats.count(); ++j)
                EXPECT_NEAR(covariance(i, j), std::exp(-std::abs(hats.peak(i) - hats.peak(j)) / 0.25), 1e-12);
        }
        Eigen::VectorXd impulse = Eigen::VectorXd::Zero(disturbing.random());
        impulse(first) = 1;
        const Eigen::VectorXd heights = disturbing.heights(impulse);
        EXPECT_EQ(heights.head(first).norm(), 0) << "of another kind";
        EXPECT_EQ(heights.tail(heights.size() - hats.end()).norm(), 0) << "of another kind";
        EXPECT_NEAR(heights(first + 1), std::exp(-hats.apart / 0.25), 1e-12);
        first = hats.end();
    }
    for (const diagnose::model::Hats& hats : hatsOver(2.4, diagnose::model::Resolution::rough))
        EXPECT_EQ(hats.apart, 0.25);
}

// A steady turn; `slips` rad/s of sideslip from 5 s on.
RecordedDrive turning(double slips, double speed = 20) {
    RecordedDrive drive;
    const std::size_t rows = 200;
    std::vector<double> times;
    for (std::size_t i = 0; i < rows; ++i) times.push_back((static_cast<double>(i) + 0.5) * kBlock);
    drive.time = times;
    drive.log.channels = {{"time", "s", times}, {"chassis.vx", "m/s", std::vector<double>(rows, speed)}};
    drive.measured.resize(3 * static_cast<Eigen::Index>(rows));
    for (const char* name : {"chassis.vx", "chassis.ay", "chassis.yaw_rate"}) {
        const auto first = static_cast<Eigen::Index>(drive.channels.size() * rows);
        drive.channels.push_back({.name = name, .measured = {}, .first_row = first, .times = times});
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const auto row = static_cast<Eigen::Index>(i), n = static_cast<Eigen::Index>(rows);
        drive.measured(row) = speed;
        drive.measured(n + row) = 6;
        drive.measured(2 * n + row) = 6 / speed - (times[i] > 5 ? slips : 0);
    }
    return drive;
}

TEST(Sliding, ADriveEndsWhereTheCarBeginsToSlideAndItsModelDoesNot) {
    const RecordedDrive drive = turning(0.2), model = turning(0);
    // 0.08 rad are reached 0.4 s after the beginning, and the window looks back 1.5 s.
    EXPECT_NEAR(slideApart(drive, model.measured), 5 + 0.4 - 1.5, 0.1);
    EXPECT_NEAR(slideApart(model, drive.measured), 5 + 0.4 - 1.5, 0.1) << "or the other way round";
}

TEST(Sliding, IsJudgedBySideslipInASlowCarToo) {
    EXPECT_NEAR(slideApart(turning(0.2, 2), turning(0, 2).measured), 5 + 0.4 - 1.5, 0.1) << "a car of scale 1:10";
    RecordedDrive more = turning(0, 2), model = turning(0, 2);
    const Eigen::Index n = more.measured.size() / 3;
    more.measured.segment(n, n).array() += 0.5;  // of lateral acceleration ...
    more.measured.tail(n).array() += 0.5 / 2;    // ... and the yaw rate that goes with it: a tighter turn
    EXPECT_EQ(slideApart(more, model.measured), kInfinity) << "another turn is no slide";
}

TEST(Sliding, AnAccelerometersZeroIsNoSlide) {
    for (const double speed : {8.0, 20.0}) {
        RecordedDrive tilted = turning(0, speed), both = turning(0.2, speed);
        const RecordedDrive model = turning(0, speed);
        const Eigen::Index n = model.measured.size() / 3;
        for (RecordedDrive* one : {&tilted, &both}) one->measured.segment(n, n).array() += 0.45;
        EXPECT_EQ(slideApart(tilted, model.measured), kInfinity) << speed;
        EXPECT_NEAR(slideApart(both, model.measured), 5 + 0.4 - 1.5, 0.1) << "a slide beside it";
    }
    RecordedDrive long_slide = turning(0);
    long_slide.measured.segment(200, 200).array() += 4;  // 0.2 rad/s from the start: more than any zero
    EXPECT_LT(slideApart(long_slide, turning(0).measured), 1);
}

// Where the model follows the measured speed, that is not compared.
TEST(Sliding, IsSeenWhereTheSpeedIsFollowed) {
    const auto withoutSpeed = [](RecordedDrive drive) {
        drive.channels.erase(drive.channels.begin());
        return drive;
    };
    const RecordedDrive drive = withoutSpeed(turning(0.2)), model = withoutSpeed(turning(0));
    EXPECT_NEAR(slideApart(drive, model.measured), 5 + 0.4 - 1.5, 0.1);
    EXPECT_EQ(slideApart(drive, drive.measured), kInfinity);
}

// The same drives with their lateral velocity measured too.
RecordedDrive withLateralVelocity(RecordedDrive drive, double slip_rate) {
    const std::vector<double> times = drive.channels.front().times;
    const auto rows = static_cast<Eigen::Index>(times.size());
    drive.channels.push_back({.name = "chassis.vy", .measured = {}, .first_row = 3 * rows, .times = times});
    drive.measured.conservativeResize(4 * rows);
    for (Eigen::Index i = 0; i < rows; ++i)
        drive.measured(3 * rows + i) = drive.measured(i) * slip_rate * std::max(0.0, times[i] - 5);
    return drive;
}

TEST(Sliding, LateralVelocityShowsItWhereItIsMeasured) {
    const RecordedDrive model = withLateralVelocity(turning(0), 0);
    EXPECT_NEAR(slideApart(withLateralVelocity(turning(0), 0.2), model.measured), 5 + 0.4 - 1.5, 0.1);
    RecordedDrive skewed = model;
    skewed.measured.segment(200, 200).array() *= 1.3;  // 1.8 m/s2 too much, 0.09 rad/s
    EXPECT_EQ(slideApart(skewed, model.measured), kInfinity) << "a wrong accelerometer is no slide";
}

TEST(Sliding, ACarAtRestDoesNotSlide) {
    RecordedDrive rest = turning(0, 0);
    rest.measured.setZero();
    EXPECT_EQ(slideApart(rest, rest.measured), kInfinity);
}

TEST(Sliding, WhatIsLeftOutIsSaidWithItsTimeAndWhoSlid) {
    RecordedDrive whole = turning(0), own = turning(0), before = turning(0);
    whole.name = "whole", own.name = "own", before.name = "before";
    for (RecordedDrive* one : {&whole, &own, &before}) one->time = {0, 10};
    own.until = 3.9;
    before.until = before.until_reference = 5.2;
    const std::vector<RecordedDrive> drives{whole, own, before};
    const std::vector<std::string> said = leftOut(drives, endsOf(drives));
    ASSERT_EQ(said.size(), 2u);
    own.until = 0;
    EXPECT_NE(leftOut(std::vector{own}, {0}).front().find("the units and signs of steering"), std::string::npos)
        << "nobody slides from the beginning";
    EXPECT_TRUE(said[0].starts_with(
        "own: not compared after 3.9 s of 10.0 s. From then on, the car slides and its model does not"))
        << said[0];
    EXPECT_TRUE(said[1].starts_with(
        "before: not compared after 5.2 s of 10.0 s. From then on, the car of the reference slides"))
        << said[1];
}

TEST(Gap, EndsTheDriveWhereAnInputOfTheDriverIsMissing) {
    const Recording pedals{.log = "a.csv"}, followed{.log = "a.csv", .speed = SpeedReplay::followed};
    Log log{{{"time", "s", {}},
             {"driver.steering_wheel_angle", "rad", {}},
             {"driver.brake", "-", {}},
             {"chassis.vx", "m/s", {}},
             {"chassis.yaw_rate", "rad/s", {}}}};
    for (int i = 0; i < 1000; ++i) {
        const double values[] = {0.01 * i, 0.1, 0, 20, 0.05};
        for (std::size_t k = 0; k < 5; ++k) log.channels[k].values.push_back(values[k]);
    }
    const auto without = [&](std::size_t channel, std::size_t first, std::size_t count) {
        Log changed = log;
        for (std::size_t i = first; i < first + count; ++i) changed.channels[channel].values[i] = std::nan("");
        return changed;
    };
    EXPECT_EQ(recordedDrive(pedals, log, {}).until, kInfinity);
    EXPECT_EQ(recordedDrive(pedals, without(1, 400, 20), {}).until, kInfinity) << "a short one is bridged";
    EXPECT_NEAR(recordedDrive(pedals, without(1, 400, 60), {}).until, 3.99, 1e-9);
    EXPECT_NEAR(recordedDrive(pedals, without(2, 940, 60), {}).until, 9.39, 1e-9) << "at the end";
    EXPECT_EQ(recordedDrive(pedals, without(1, 0, 60), {}).until, 0) << "at the beginning";
    EXPECT_EQ(recordedDrive(pedals, without(3, 400, 60), {}).until, kInfinity) << "the speed is no input here,";
    EXPECT_NEAR(recordedDrive(followed, without(3, 400, 60), {}).until, 3.99, 1e-9) << "but here";
    EXPECT_EQ(recordedDrive(pedals, without(4, 400, 60), {}).until, kInfinity) << "what is compared may have gaps";

    const std::vector<RecordedDrive> drives{recordedDrive(pedals, without(1, 400, 60), {})};
    const std::vector<std::string> said = leftOut(drives, endsOf(drives));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_TRUE(
        said[0].starts_with("a.csv: not compared after 4.0 s of 10.0 s. "
                            "driver.steering_wheel_angle is missing for 0.6 s there"))
        << said[0];
}

TEST(Sliding, CarsThatSlideAlikeDoNotEndTheDrive) {
    EXPECT_EQ(slideApart(turning(0.2), turning(0.2).measured), kInfinity);
    EXPECT_EQ(slideApart(turning(0.03), turning(0).measured), kInfinity) << "a gyro of so much bias is no slide";
}

// Rows of a yaw rate that was read so often per second, with this much added to some of its readings.
Eigen::VectorXd rowsOfYawRate(double rate, double added, std::size_t first = 0, std::size_t after = 0) {
    Log log{.channels = {{"time", "s", {}}, {"chassis.vx", "m/s", {}}, {"chassis.yaw_rate", "rad/s", {}}}};
    Random random(7);
    for (std::size_t i = 0; i < static_cast<std::size_t>(10 * rate); ++i) {
        const double t = static_cast<double>(i) / rate, noise = 0.002 * random.normal();
        log.channels[0].values.push_back(t);
        log.channels[1].values.push_back(20);
        log.channels[2].values.push_back(0.3 * std::sin(std::numbers::pi * t) + noise);
        if (i >= first && i < after) log.channels[2].values.back() += added;
    }
    static const Recording recording{.log = "drive.csv", .speed = SpeedReplay::followed};
    return recordedDrive(recording, log, {}).measured;
}

TEST(Readings, ThatAreSpikesAreInterpolated) {
    const double apart = (rowsOfYawRate(100, 0.2, 300, 301) - rowsOfYawRate(100, 0)).cwiseAbs().maxCoeff();
    EXPECT_LT(apart, 0.004) << "two standard deviations of the noise; the spike would change a row by 0.04";
}

TEST(Readings, ThatTheCarMayHaveShownAreKept) {
    EXPECT_GT((rowsOfYawRate(100, 0.2, 300, 310) - rowsOfYawRate(100, 0)).cwiseAbs().maxCoeff(), 0.19) << "100 ms";
    EXPECT_GT((rowsOfYawRate(20, 0.2, 60, 61) - rowsOfYawRate(20, 0)).cwiseAbs().maxCoeff(), 0.19) << "a slow sensor";
}

// The mean of two samples has more noise than that of five; all rows count alike.
TEST(Rows, AreMeansOfAtLeastHalfTheSamplesOfABlock) {
    const Recording recording{.log = "drive.csv"};
    Log log{.channels = {{"time", "s", {}}, {"chassis.vx", "m/s", {}}, {"chassis.yaw_rate", "rad/s", {}}}};
    for (int i = 0; i <= 1000; ++i) {
        const double values[] = {0.01 * i, 20, 0.1};
        for (std::size_t k = 0; k < 3; ++k) log.channels[k].values.push_back(values[k]);
    }
    const auto timesOfYawRate = [&] {
        const RecordedDrive drive = recordedDrive(recording, log, {});
        EXPECT_EQ(drive.channels.back().name, "chassis.yaw_rate");
        EXPECT_EQ(drive.measured.size(), drive.channels.front().rows() + drive.channels.back().rows());
        return drive.channels.back().times;
    };
    EXPECT_EQ(timesOfYawRate().size(), 200u) << "the sample at 10 s is the only one of its block";
    for (const int missing : {500, 501, 600, 601, 602}) log.channels[2].values[missing] = std::nan("");
    const std::vector<double> times = timesOfYawRate();
    EXPECT_EQ(times.size(), 199u);
    const auto has = [&](double middle) {
        return std::any_of(times.begin(), times.end(), [&](double time) { return std::abs(time - middle) < 1e-9; });
    };
    EXPECT_TRUE(has(5.025)) << "three samples";
    EXPECT_FALSE(has(6.025)) << "two samples";
}

TEST(Replay, ACarIsAsFastAsItsSpeedometerStandsFor) {
    const Recording recording{.log = "a.csv"};
    RecordedDrive drive = turning(0);
    drive.recording = &recording;
    drive.time = {0, 10};
    drive.log = {{{"time", "s", {0, 10}}}};
    drive.inputs = drive.log;
    drive.speed = 20;
    const Subject nominal;
    Subject subject;
    subject.instruments.speed = {.gain = 0.8, .bias = 4};
    EXPECT_DOUBLE_EQ(replayOf(drive, subject, {nominal, 0.004, {}}).start.speed, 20.0);
    subject.instruments.speed = {.gain = 1, .bias = 4};
    EXPECT_DOUBLE_EQ(replayOf(drive, subject, {nominal, 0.004, {}}).start.speed, 16.0);
}

TEST(Replay, ASpeedThatIsFollowedIsTheMeasuredOneAllAlong) {
    const Recording recording{.log = "a.csv", .speed = SpeedReplay::followed};
    Log log{{{"time", "s", {}}, {"chassis.vx", "m/s", {}}, {"chassis.yaw_rate", "rad/s", {}}}};
    for (int i = 0; i <= 400; ++i) {
        const double t = 0.01 * i;
        log.channels[0].values.push_back(t);
        log.channels[1].values.push_back(20 - 3 * t);
        log.channels[2].values.push_back(0.1 * t);
    }
    const RecordedDrive drive = recordedDrive(recording, log, {});
    const Scenario scenario = replayOf(drive, {}, {{}, 0.004, {}});
    const auto* follow = std::get_if<FollowSpeed>(&scenario.phases.front().throttle);
    ASSERT_TRUE(follow);
    for (const double t : {0.0, 1.0, 3.9}) EXPECT_NEAR(follow->profile(t), 20 - 3 * t, 1e-6);
}

}  // namespace
}  // namespace tread::diagnose_rows_test
