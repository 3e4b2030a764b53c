// Further instruments of one quantity, and positions: their readings, their numbers and the rows of the catalogue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/fields/numbers.h"
#include "base/math/random.h"
#include "diagnose/catalogue/catalogue.h"
#include "diagnose/catalogue/effects_to_consider.h"
#include "diagnose/diagnose.h"
#include "diagnose/model/parameter.h"
#include "recording/further_instruments.h"
#include "recording/observation.h"
#include "recording/position.h"
#include "recording/recorded_drive.h"
#include "recording/subject_paths.h"
#include "shared/simple_car.h"

namespace tread::diagnose_instruments_test {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::catalogue::Effect;
using recording::FurtherInstrument;
using recording::Instruments;
using recording::readings;
using recording::RecordedDrive;
using recording::Recording;
using recording::Subject;

constexpr double kRate = 250, kOmega = 2, kAmplitude = 0.3, kSpeed = 20;  // 1/s, rad/s, rad/s, m/s

Instruments withCan() {
    Instruments instruments;
    instruments.further = {{.channel = "chassis.yaw_rate@can", .instrument = {}},
                           {.channel = "chassis.ay@can", .instrument = {}}};
    instruments.mountings = {{.source = "can", .unit = {}}};
    return instruments;
}

double yawRate(double t) {
    return kAmplitude * std::sin(kOmega * t);
}

// Ten seconds of a car that turns to and fro at constant speed.
Log motion() {
    Log log{{{"time", "s", {}},
             {"chassis.vx", "m/s", {}},
             {"chassis.vy", "m/s", {}},
             {"chassis.ax", "m/s2", {}},
             {"chassis.ay", "m/s2", {}},
             {"chassis.yaw_rate", "rad/s", {}},
             {"chassis.roll_rate", "rad/s", {}},
             {"chassis.pitch_rate", "rad/s", {}}}};
    for (int i = 0; i <= 10 * kRate; ++i) {
        const double t = i / kRate, r = yawRate(t);
        const double row[] = {t, kSpeed, 0.1 * r, 0, kSpeed * r, r, 0, 0};
        for (std::size_t c = 0; c < log.channels.size(); ++c) log.channels[c].values.push_back(row[c]);
    }
    return log;
}

std::vector<double> hundredHertz(double seconds) {
    std::vector<double> times;
    for (int i = 0; i <= 100 * seconds; ++i) times.push_back(i / 100.0);
    return times;
}

TEST(FurtherInstrument, ItsNumbersHavePathsOfTheChannel) {
    Subject subject;
    subject.instruments = withCan();
    EXPECT_EQ(numberAt(subject, "instruments.further.chassis.yaw_rate@can.delay"),
              &subject.instruments.further[0].instrument.delay);
    EXPECT_EQ(numberAt(subject, "instruments.mountings.can.x"), &subject.instruments.mountings[0].unit.x);
    EXPECT_EQ(recording::pathInFirst("instruments.further.chassis.yaw_rate@can.delay"), "instruments.yaw_rate.delay");
    EXPECT_EQ(recording::pathInFirst("instruments.further.wheel.rear_left.spin@abs.gain"),
              "instruments.wheel_speed.gain");
    EXPECT_EQ(recording::pathInFirst("instruments.mountings.can.x"), "instruments.inertial_unit.x");
    EXPECT_EQ(recording::pathInFirst("mass"), "");
    ASSERT_NE(recording::subjectNumber("instruments.further.chassis.yaw_rate@can.delay"), nullptr);
    EXPECT_EQ(recording::pathFault("instruments.mountings.can.x"), "");
    EXPECT_NE(recording::pathFault("instruments.mountings.can.colour"), "");
}

TEST(FurtherInstrument, ReadsWithItsOwnGainBiasAndDelay) {
    Instruments instruments = withCan();
    instruments.latency = 0.1;
    instruments.further[0].instrument = {.gain = 1.1, .bias = 0.02, .delay = 0.4};
    const std::vector<double> times = hundredHertz(10);
    const std::vector<double> first = readings(motion(), instruments, "chassis.yaw_rate", times);
    const std::vector<double> further = readings(motion(), instruments, "chassis.yaw_rate@can", times);
    // Linear interpolation between rows 4 ms apart errs by at most 1/8 step^2 omega^2 amplitude.
    constexpr double kInterpolation = 3e-6;
    for (std::size_t i = 50; i < times.size(); ++i) {
        EXPECT_NEAR(first[i], yawRate(times[i] - 0.1), kInterpolation);
        EXPECT_NEAR(further[i], 1.1 * yawRate(times[i] - 0.5) + 0.02, kInterpolation);
    }
    for (std::size_t i = 0; i < 50; ++i)
        EXPECT_EQ(further[i], 0.02) << "before the drive the car moves as at its start";
}

TEST(FurtherInstrument, IsMountedOnItsOwn) {
    Instruments instruments = withCan();
    instruments.mountings[0].unit = {.x = 0.5, .roll = 0.01, .yaw = 0.02};
    const std::vector<double> times = hundredHertz(10);
    const std::vector<double> first = readings(motion(), instruments, "chassis.ay", times);
    const std::vector<double> further = readings(motion(), instruments, "chassis.ay@can", times);
    const std::vector<double> ax = readings(motion(), instruments, "chassis.ax@can", times);
    for (std::size_t i = 1; i + 1 < times.size(); ++i) {
        const double yaw_acceleration = kAmplitude * kOmega * std::cos(kOmega * times[i]);
        EXPECT_NEAR(first[i], kSpeed * yawRate(times[i]), 1e-3);
        EXPECT_NEAR(further[i] - first[i], 0.5 * yaw_acceleration + 0.01 * 9.80665, 1e-3);
        EXPECT_NEAR(ax[i], 0.02 * kSpeed * yawRate(times[i]) - 0.5 * yawRate(times[i]) * yawRate(times[i]), 2e-3);
    }
}

TEST(FurtherInstrument, IsKnownAsWellAsTheFirstOfItsQuantity) {
    Subject subject;
    subject.vehicle = loadVehicle(sourceFile("vehicles/compact.yaml"));
    subject.instruments = withCan();
    const auto found = diagnose::model::nuisances(subject, {{"instruments.further.chassis.ay@can.bias", 0, 0.6}});
    const auto by = [&](const std::string& path) {
        for (const auto& one : found)
            if (one.name() == path) return one.moves[0].by;
        return 0.0;
    };
    EXPECT_GT(by("instruments.yaw_rate.bias"), 0);
    EXPECT_EQ(by("instruments.further.chassis.yaw_rate@can.bias"), by("instruments.yaw_rate.bias"));
    EXPECT_EQ(by("instruments.mountings.can.roll"), by("instruments.inertial_unit.roll"));
    EXPECT_EQ(by("instruments.further.chassis.ay@can.bias"), 0.6 / std::sqrt(3.0)) << "the file says otherwise";
    EXPECT_EQ(by("instruments.latency"), 0.005 / std::sqrt(3.0));
}

TEST(FurtherInstrument, CatalogueHasRowsForThoseThatTheLogsHold) {
    recording::DiagnosisFile file;
    const std::size_t without = diagnose::catalogue::effectsToConsider(file).size();
    recording::addFurtherInstruments(file.instruments, {motion()});
    EXPECT_EQ(diagnose::catalogue::effectsToConsider(file).size(), without);
    Log log = motion();
    log.channels.push_back({"chassis.yaw_rate@can", "rad/s", log.channels[5].values});
    log.channels.push_back({"wheel.front_left.spin@abs", "rad/s", log.channels[5].values});
    log.channels.push_back({"wheel.front_right.spin@abs", "rad/s", log.channels[5].values});
    recording::addFurtherInstruments(file.instruments, {log, log});
    ASSERT_EQ(file.instruments.further.size(), 3u);
    EXPECT_TRUE(file.instruments.mountings.empty()) << "neither gyros nor wheel speeds depend on their place";
    const std::vector<Effect> all = diagnose::catalogue::effectsToConsider(file);
    const auto row = [&](const std::string& name) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Effect& one) { return one.name == name; });
        return found == all.end() ? Effect{} : *found;
    };
    ASSERT_EQ(row("yaw_rate_delay@can").knobs.size(), 1u);
    EXPECT_EQ(row("yaw_rate_delay@can").knobs[0].paths,
              std::vector<std::string>{"instruments.further.chassis.yaw_rate@can.delay"});
    EXPECT_EQ(row("wheel_speed_scale@abs").knobs.at(0).paths.size(), 2u) << "the wheels of one source share a scale";
    EXPECT_TRUE(row("gyro_bias@can").knobs.size() == 1 && row("gyro_scale@can").knobs.size() == 1);
    EXPECT_TRUE(row("acceleration_delay@can").name.empty()) << "no accelerometers there";
    file.effects = {"yaw_rate_delay@*"};
    EXPECT_EQ(diagnose::catalogue::effectsToConsider(file).size(), 1u);
}

TEST(FurtherInstrument, MotionFromPositionsHasNoScaleToBeWrong) {
    recording::DiagnosisFile file;
    file.instruments.further = {{"chassis.yaw_rate@position", {}}, {"chassis.vx@position", {}}};
    std::vector<std::string> names;
    for (const Effect& effect : diagnose::catalogue::furtherInstrumentEffects(file.instruments))
        names.push_back(effect.name);
    const auto has = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
    EXPECT_TRUE(has("yaw_rate_delay@position") && has("speed_delay@position"));
    EXPECT_FALSE(has("gyro_scale@position") || has("gyro_bias@position") || has("speed_scale@position"));
}

TEST(FurtherInstrument, RowsBeginWhereTheDelayedReadingShowsTheDrive) {
    Log log = motion();
    for (const char* name : {"chassis.yaw_rate@can", "chassis.yaw_rate@other"})
        log.channels.push_back({name, "rad/s", log.channels[5].values});
    recording::DiagnosisFile file;
    file.instruments = withCan();
    file.instruments.further[0].instrument.delay = 0.5;
    const Recording recording{.log = "a", .name = "a"};
    const RecordedDrive drive = recordedDrive(recording, log, file);
    const auto channel = [&](const std::string& name) {
        return *std::find_if(drive.channels.begin(), drive.channels.end(),
                             [&](const auto& one) { return one.name == name; });
    };
    EXPECT_NEAR(channel("chassis.yaw_rate").times.front(), 0.025, 1e-9);
    EXPECT_NEAR(channel("chassis.yaw_rate@other").times.front(), 0.025, 1e-9);
    EXPECT_NEAR(channel("chassis.yaw_rate@can").times.front(), 0.525, 1e-9);
    EXPECT_EQ(channel("chassis.yaw_rate@can").times.back(), channel("chassis.yaw_rate").times.back());
}

// The slaloms of the simple car, with a second gyro that reads `delay` later.
simple_car::Case withSecondGyro(double delay) {
    simple_car::Case made = simple_car::recorded(simple_car::Case{}.nominal.vehicle.steering.ratio,
                                                 simple_car::Case{}.nominal.vehicle.aero.drag_area, 5);
    Random random(8);
    for (Log& log : made.recorded.logs) {
        const std::vector<double> time = log.channels[0].values, yaw_rate = log.find("chassis.yaw_rate")->values;
        std::vector<double> late(time.size());
        for (std::size_t i = 0; i < time.size(); ++i) {
            const auto before = std::max<std::ptrdiff_t>(
                0, std::ssize(time) > 0 ? static_cast<std::ptrdiff_t>(i) - std::lround(delay * 100) : 0);
            late[i] = yaw_rate[static_cast<std::size_t>(before)] + 0.003 * random.normal();
        }
        log.channels.push_back({"chassis.yaw_rate@can", "rad/s", late});
    }
    recording::addFurtherInstruments(made.file.instruments, made.recorded.logs);
    made.nominal.instruments = made.file.instruments;
    return made;
}

// Half a second is the end of the plausible range, where nothing is named.
TEST(FurtherInstrument, ItsDelayIsFoundUpToNearlyHalfASecond) {
    for (const double delay : {0.06, 0.25, 0.45}) {
        const simple_car::Case made = withSecondGyro(delay);
        std::vector<Effect> effects{simple_car::effect("steering_ratio", "steering.ratio"),
                                    simple_car::effect("drag", "aero.drag_area")};
        for (const Effect& effect : diagnose::catalogue::furtherInstrumentEffects(made.file.instruments))
            effects.push_back(effect);
        for (const Effect& effect : diagnose::catalogue::instrumentEffects()) {
            if (effect.name == "yaw_rate_delay" || effect.name == "gyro_scale") effects.push_back(effect);
        }
        const Diagnosis found =
            diagnose::diagnosisOf(made.nominal, made.file, made.recorded, effects, simple_car::options());
        ASSERT_FALSE(found.effects.empty());
        const auto& best = found.effects.front();
        EXPECT_TRUE(best.name == "yaw_rate_delay@can" || best.name == "sensor_delay@can") << best.name;
        ASSERT_FALSE(best.parameters.empty());
        EXPECT_NEAR(best.parameters.begin()->second.value, delay, 0.01);
    }
}

// ---- Positions -----------------------------------------------------------------------------------------------------

// A circle of 20 m at 10 m/s about a tracked point, the heading wrapped, the position held for `hold` samples.
Log onACircle(int hold) {
    Log log{{{"time", "s", {}}, {"position.x", "m", {}}, {"position.y", "m", {}}, {"position.heading", "rad", {}}}};
    constexpr double kRadius = 20, kSideslip = 0.05;  // m, rad
    for (int i = 0; i <= 2000; ++i) {
        const double t = i / 100.0, of_update = (i / hold) * hold / 100.0, angle = 0.5 * of_update;
        const double row[] = {t, kRadius * std::sin(angle), -kRadius * std::cos(angle),
                              std::remainder(angle - kSideslip, 2 * std::numbers::pi)};
        for (std::size_t c = 0; c < 4; ++c) log.channels[c].values.push_back(row[c]);
    }
    recording::addVelocities(log);
    return log;
}

TEST(Position, GivesVelocitiesAlongTheAxesOfTheHeading) {
    for (const int hold : {1, 10}) {
        const Log log = onACircle(hold);
        // The chord of 0.1 s has one direction, while the heading turns by 0.025 rad before and after its middle.
        const double tolerance = hold == 1 ? 1e-3 : 0.026;
        for (std::size_t i = 20; i < 1980; ++i) {
            ASSERT_NEAR(log.find("chassis.vx@position")->values[i], 10 * std::cos(0.05), tolerance + 0.01);
            ASSERT_NEAR(log.find("chassis.vy@position")->values[i], 10 * std::sin(0.05), 10 * tolerance);
            ASSERT_NEAR(log.find("chassis.yaw_rate@position")->values[i], 0.5, 1e-6) << "unwrapped";
        }
    }
}

TEST(Position, WithoutHeadingTheSpeedAloneIsKnown) {
    Log log = onACircle(1);
    std::erase_if(log.channels, [](const Channel& one) { return one.name.find('@') != std::string::npos; });
    log.channels.pop_back();
    recording::addVelocities(log);
    EXPECT_EQ(log.find("chassis.yaw_rate@position"), nullptr);
    EXPECT_EQ(log.find("chassis.vy@position"), nullptr);
    EXPECT_NEAR(log.find("chassis.vx@position")->values[500], 10, 1e-3);
}

TEST(Position, WhatItDoesInALongGapIsUnknown) {
    Log log = onACircle(1);
    std::erase_if(log.channels, [](const Channel& one) { return one.name.find('@') != std::string::npos; });
    for (std::size_t c = 1; c < 4; ++c)
        std::fill_n(log.channels[c].values.begin() + 500, 100, log.channels[c].values[499]);
    recording::addVelocities(log);
    const std::vector<double>& vx = log.find("chassis.vx@position")->values;
    EXPECT_TRUE(std::isnan(vx[550]));
    EXPECT_NEAR(vx[450], 10 * std::cos(0.05), 1e-3);
    EXPECT_NEAR(vx[650], 10 * std::cos(0.05), 1e-3);
}

TEST(Position, MovesWithTheTrackedPoint) {
    Instruments instruments;
    instruments.mountings = {{.source = "position", .unit = {.x = -1.2, .y = 0.3, .yaw = 0.01}}};
    const std::vector<double> times = hundredHertz(10);
    const std::vector<double> vx = readings(motion(), instruments, "chassis.vx@position", times);
    const std::vector<double> vy = readings(motion(), instruments, "chassis.vy@position", times);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double r = yawRate(times[i]);
        EXPECT_NEAR(vx[i], kSpeed - 0.3 * r + 0.01 * 0.1 * r, 1e-4);
        EXPECT_NEAR(vy[i], 0.1 * r - 1.2 * r - 0.01 * kSpeed, 1e-4);
    }
}

TEST(Position, AloneItGivesTheStartSpeedAndTheRowsOfADrive) {
    recording::DiagnosisFile file;
    file.channels = {{.channel = "position.x", .noise = 0.001}, {.channel = "position.heading", .noise = 0.002}};
    const Recording recording{.log = "a", .name = "a"};
    const RecordedDrive drive = recordedDrive(recording, onACircle(1), file);
    EXPECT_NEAR(drive.speed, 10 * std::cos(0.05), 0.02);
    ASSERT_EQ(drive.channels.size(), 3u);
    EXPECT_EQ(drive.channels[0].name, "chassis.vx@position");
    EXPECT_NEAR(drive.channels[0].noise, 0.001 / recording::kBlock, 1e-12);
    EXPECT_NEAR(drive.channels[1].noise, 0.002 / recording::kBlock, 1e-12);
}

}  // namespace
}  // namespace tread::diagnose_instruments_test
