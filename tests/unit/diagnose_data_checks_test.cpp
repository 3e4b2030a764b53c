// Checks of recordings: a right one gives no warning, and each fault that people make gives the one that names it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "base/math/random.h"
#include "recording/checks/data_checks.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"
#include "shared/vehicle_run.h"

namespace tread::diagnose_data_checks_test {
namespace {

using recording::DiagnosisFile;
using recording::Subject;
using recording::checks::DataWarning;
using recording::checks::dataWarnings;

std::vector<double>& of(Log& log, std::string_view name) {
    for (Channel& channel : log.channels) {
        if (channel.name == name) return channel.values;
    }
    throw std::runtime_error("no channel " + std::string(name));
}

// Three drives of the compact car at 100 Hz, with the noise of usual instruments: a turn under brakes, a slalom, and a
// step steer, held out.
struct Case {
    DiagnosisFile file;
    std::vector<Log> logs, references = std::vector<Log>(3);
    Subject nominal;

    std::vector<DataWarning> warnings() const {
        return dataWarnings(file, {.logs = logs, .references = references}, nominal);
    }
};

Log measured(const std::string& scenario, double speed) {
    Scenario driven = shared::scenario(scenario);
    driven.start.speed = speed;
    driven.step = 0.002;
    driven.log = {.rate = 100,
                  .channels = {"driver.steering_wheel_angle", "driver.throttle", "driver.brake", "chassis.vx",
                               "chassis.ax", "chassis.ay", "chassis.yaw_rate", "chassis.roll", "chassis.roll_rate",
                               "wheel.*.spin", "driveline.gear"}};
    Log log = simulate(shared::compact(), driven);
    Random random(7);
    for (Channel& channel : log.channels) {
        const double noise = channel.name.starts_with("chassis.a")             ? 0.05
                             : channel.name == "chassis.vx"                    ? 0.02
                             : channel.name.starts_with("chassis.")            ? 0.002
                             : channel.name.find(".spin") != std::string::npos ? 0.05
                                                                               : 0;
        if (noise == 0) continue;
        for (double& value : channel.values) value += noise * random.normal();
    }
    return log;
}

const Case& right() {
    static const Case made = [] {
        Case c;
        c.nominal.vehicle = shared::compact();
        c.file.recordings = {{.log = "brake.csv", .name = "brake"},
                             {.log = "sine.csv", .name = "sine"},
                             {.log = "step.csv", .name = "step", .hold_out = true}};
        c.logs = {measured("braking_in_turn", 25), measured("sine_steer", 16), measured("step_steer_80", 22)};
        return c;
    }();
    return made;
}

void expectOnly(const Case& wrong, const std::string& where, const std::string& what) {
    const auto warnings = wrong.warnings();
    bool found = false;
    for (const DataWarning& warning : warnings)
        found = found || (warning.where == where && warning.what.find(what) != std::string::npos);
    EXPECT_TRUE(found) << where << ": " << what;
    for (const DataWarning& warning : warnings) {
        EXPECT_FALSE(warning.why.empty() || warning.advice.empty()) << toText(warning);
        if (!found) std::printf("  %s\n", toText(warning).c_str());
    }
    EXPECT_LE(warnings.size(), 6u) << "a single fault is not drowned in others";
}

TEST(DataChecks, RightRecordingsGiveNoWarning) {
    for (const DataWarning& warning : right().warnings()) ADD_FAILURE() << toText(warning);
}

// At speed and at the limit, sideslip makes ay late and smaller than vx times yaw rate.
TEST(DataChecks, SideslipThatIsNotMeasuredIsNoErrorOfAnInstrument) {
    Case c;
    c.nominal.vehicle = shared::compact();
    for (const auto& [scenario, speed] : {std::pair{"step_steer_80", 30.5},
                                          {"sine_sweep", 25.0},
                                          {"weave", 28.0},
                                          {"one_period_sine", 27.0},
                                          {"sine_with_dwell", 22.0}}) {
        c.file.recordings.push_back({.log = std::string(scenario) + ".csv", .name = scenario});
        c.logs.push_back(measured(scenario, speed));
    }
    c.references.resize(c.logs.size());
    for (const DataWarning& warning : c.warnings())
        EXPECT_FALSE(warning.where.ends_with("chassis.ay")) << toText(warning);
}

// The same drives before a change, of which there was none.
Case withReferences() {
    Case c = right();
    for (std::size_t i = 0; i < c.logs.size(); ++i) {
        c.file.recordings[i].reference = "before/" + c.file.recordings[i].log;
        c.references[i] = c.logs[i];
    }
    return c;
}

TEST(DataChecks, ReferencesAreLookedAtLikeRecordingsAndNamedByTheirFile) {
    for (const DataWarning& warning : withReferences().warnings()) ADD_FAILURE() << toText(warning);
    Case wrong = withReferences();
    for (double& value : of(wrong.references[1], "chassis.ay")) value = -value;
    expectOnly(wrong, "reference of sine (before/sine.csv), chassis.ay", "has the opposite sign of");
    wrong = withReferences();
    for (std::size_t i = 50; i < 100; ++i) of(wrong.references[2], "chassis.yaw_rate")[i] = std::nan("");
    expectOnly(wrong, "reference of step (before/step.csv), chassis.yaw_rate", "50 of");
}

TEST(DataChecks, ChannelsThatAReferenceHasNotAreNamed) {
    Case wrong = withReferences();
    std::erase_if(wrong.references[0].channels,
                  [](const Channel& one) { return one.name.starts_with("chassis.roll"); });
    const std::string where = "reference of brake (before/brake.csv), chassis.roll, chassis.roll_rate";
    expectOnly(wrong, where, "not measured here");
    wrong.file.channels = {{.channel = "chassis.yaw_rate"}};
    EXPECT_TRUE(wrong.warnings().empty()) << "nobody asked for roll";
}

TEST(DataChecks, ReferencesOfSomeRecordingsOnlyAreSaid) {
    Case wrong = withReferences();
    wrong.file.recordings[1].reference.clear();
    expectOnly(wrong, "all recordings", "only some of the recordings have a reference");
}

TEST(DataChecks, InputsThatNoDriverGivesAreTakenForAnotherUnit) {
    Case wrong = right();
    for (double& value : of(wrong.logs[0], "driver.brake")) value *= 100;
    expectOnly(wrong, "brake, driver.brake", "as if it were in per cent");
    wrong = right();
    for (double& value : of(wrong.logs[1], "driver.steering_wheel_angle")) value *= 180 / 3.14159;
    expectOnly(wrong, "sine, driver.steering_wheel_angle", "as if it were in degrees");
}

TEST(DataChecks, WhatWasNotMeasuredIsNotSaidToBeSmall) {
    Case wrong = right();
    for (Log& log : wrong.logs)
        std::erase_if(log.channels,
                      [](const Channel& one) { return one.name == "chassis.ay" || one.name == "chassis.yaw_rate"; });
    expectOnly(wrong, "all recordings", "neither yaw rate nor lateral acceleration");
    for (const DataWarning& warning : wrong.warnings())
        EXPECT_EQ(warning.what.find("never exceeds"), std::string::npos);
    for (Log& log : wrong.logs)
        log.channels.push_back({"chassis.ay", "m/s2", std::vector(log.samples(), std::nan(""))});
    expectOnly(wrong, "all recordings", "neither yaw rate nor lateral acceleration");
}

TEST(DataChecks, ChannelsThatNoLogHasAreNamed) {
    Case wrong = right();
    wrong.file.channels = {{.channel = "chassis.yaw_rate"}, {.channel = "chassis.sideslip"}};
    expectOnly(wrong, "all recordings", "chassis.sideslip listed under channels, but in no log");
}

TEST(DataChecks, WrongSignsAreNamed) {
    for (const std::string channel : {"chassis.ay", "chassis.ax", "chassis.roll", "driver.steering_wheel_angle"}) {
        Case wrong = right();
        const std::size_t log = channel == "chassis.ax" ? 0 : 1;  // where it does something
        for (double& value : of(wrong.logs[log], channel)) value = -value;
        expectOnly(wrong, wrong.file.recordings[log].name + ", " + channel, "has the opposite sign of");
    }
}

TEST(DataChecks, WrongUnitsAreNamed) {
    const auto scaled = [](const std::string& channel, double factor) {
        Case wrong = right();
        for (Log& log : wrong.logs) {
            for (double& value : of(log, channel)) value *= factor;
        }
        return wrong;
    };
    expectOnly(scaled("chassis.ay", 1 / 9.80665), "brake, chassis.ay", "as if one of them were in g");
    expectOnly(scaled("chassis.yaw_rate", 57.29578), "brake, chassis.ay", "as if one of them were in degrees");
    expectOnly(scaled("wheel.front_left.spin", 3.6), "brake, wheel.front_left.spin", "as if one of them were in km/h");
}

TEST(DataChecks, SwappedChannelsAreNamed) {
    Case wheels = right();
    for (Log& log : wheels.logs) std::swap(of(log, "wheel.rear_left.spin"), of(log, "wheel.rear_right.spin"));
    expectOnly(wheels, "sine, wheel.rear_left.spin and wheel.rear_right.spin", "swapped");
    Case accelerations = right();
    for (Log& log : accelerations.logs) std::swap(of(log, "chassis.ax"), of(log, "chassis.ay"));
    expectOnly(accelerations, "sine, chassis.ax and chassis.ay", "swapped");
}

Log withSideslip() {
    Scenario driven = shared::scenario("sine_steer");
    driven.start.speed = 16;
    driven.step = 0.002;
    driven.log = {.rate = 100, .channels = {"chassis.vy"}};
    return simulate(shared::compact(), driven);
}

TEST(DataChecks, DelayBetweenChannelsIsMeasured) {
    Case wrong = right();
    auto& ay = of(wrong.logs[1], "chassis.ay");
    std::rotate(ay.rbegin(), ay.rbegin() + 20, ay.rend());
    std::fill(ay.begin(), ay.begin() + 20, ay[20]);
    expectOnly(wrong, "sine, chassis.ay", "lags by 2");  // 200 ms and what sideslip adds, about 20
    // With the lateral velocity sideslip is known.
    wrong.logs[1].channels.push_back(withSideslip().channels.at(1));
    expectOnly(wrong, "sine, chassis.ay", "lags by 20");
}

TEST(DataChecks, GapsSpikesStuckHeldAndSaturatedSensorsAreNamed) {
    const auto changed = [](const std::function<void(std::vector<double>&)>& change) {
        Case wrong = right();
        change(of(wrong.logs[1], "chassis.yaw_rate"));
        return wrong;
    };
    const std::string where = "sine, chassis.yaw_rate";
    expectOnly(changed([](auto& r) { r[300] = r[301] = std::nan(""); }), where, "2 of ");
    EXPECT_TRUE(changed([](auto& r) { r[300] += 2; }).warnings().empty()) << "it is interpolated";
    expectOnly(changed([](auto& r) {
                   for (std::size_t i = 50; i + 50 < r.size(); i += 50) r[i] += 2;
               }),
               where, "values are spikes");
    expectOnly(changed([](auto& r) { std::fill(r.begin(), r.end(), 0.01); }), where, "is constant at");
    expectOnly(
        changed([](auto& r) { std::fill(r.begin() + 100, r.begin() + 100 + static_cast<int>(r.size() / 2), r[100]); }),
        where, "stays at");
    expectOnly(changed([](auto& r) {
                   const double top = 0.7 * *std::max_element(r.begin(), r.end());
                   for (double& value : r) value = std::min(value, top);
               }),
               where, "stays at its extreme value");
    expectOnly(changed([](auto& r) {
                   for (std::size_t i = 0; i < r.size(); ++i) r[i] = r[i - i % 5];
               }),
               where, "changes only at about 20");
}

TEST(DataChecks, HolesInTimeAndSlowLoggingAreNamed) {
    Case hole = right();
    auto& time = hole.logs[1].channels.front().values;
    for (std::size_t i = 400; i < time.size(); ++i) time[i] += 0.5;
    expectOnly(hole, "sine, time", "step of 0.51 s");
    Case slow = right();
    for (Channel& channel : slow.logs[1].channels) {
        std::vector<double> few;
        for (std::size_t i = 0; i < channel.values.size(); i += 10) few.push_back(channel.values[i]);
        channel.values = few;
    }
    expectOnly(slow, "sine, time", "10 samples per second");
}

TEST(DataChecks, MissingChannelsSayWhichVerdictsRemain) {
    Case wrong = right();
    for (Log& log : wrong.logs)
        std::erase_if(log.channels,
                      [](const Channel& c) { return c.name == "chassis.yaw_rate" || c.name == "chassis.ay"; });
    expectOnly(wrong, "all recordings", "neither yaw rate nor lateral acceleration");
    Case inputs = right();
    std::erase_if(inputs.logs[0].channels, [](const Channel& c) { return c.name.starts_with("driver."); });
    expectOnly(inputs, "brake, driver.steering_wheel_angle", "is missing");
    expectOnly(inputs, "brake, driver.throttle, driver.brake", "are missing");
}

TEST(DataChecks, FileOfAnotherCarIsNamed) {
    Case wrong = right();
    wrong.nominal.vehicle.steering.ratio = 40;
    expectOnly(wrong, "sine, chassis.yaw_rate", "steering ratio and wheelbase");
}

bool anyOf(const std::vector<DataWarning>& warnings, const std::string& what) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const DataWarning& one) { return toText(one).find(what) != std::string::npos; });
}

TEST(DataChecks, LockedAndSpinningWheelsAreNoWrongUnit) {
    Case locked = right();
    const auto& brake = of(locked.logs[0], "driver.brake");
    for (std::size_t i = 0; i < brake.size(); ++i) {
        if (brake[i] > 0) of(locked.logs[0], "wheel.rear_left.spin")[i] *= 0.02;
    }
    EXPECT_FALSE(anyOf(locked.warnings(), "rolling radius"));
    Case spinning = right();
    auto& front = of(spinning.logs[0], "wheel.front_left.spin");
    for (std::size_t i = front.size() / 2; i < front.size(); ++i) front[i] *= 3;
    const auto& ax = of(spinning.logs[0], "chassis.ax");
    for (std::size_t i = 0; i < front.size(); ++i)
        if (std::abs(ax[i]) < 1.5 && i >= front.size() / 2) front[i] /= 3;
    EXPECT_FALSE(anyOf(spinning.warnings(), "rolling radius"));
}

TEST(DataChecks, ASpinIsNoWrongSign) {
    // The car swaps ends for the last quarter of the slalom: the yaw rate is opposed to steering and acceleration
    // there.
    Case spin = right();
    auto& yaw_rate = of(spin.logs[1], "chassis.yaw_rate");
    for (std::size_t i = yaw_rate.size() * 3 / 4; i < yaw_rate.size(); ++i) yaw_rate[i] *= -6;
    EXPECT_FALSE(anyOf(spin.warnings(), "opposite sign")) << "the rest of the drive shows that the signs are right";
}

TEST(DataChecks, OfSeveralSignsThatDisagreeTheOddChannelIsNamed) {
    Case wrong = right();
    for (double& value : of(wrong.logs[1], "chassis.yaw_rate")) value = -value;
    expectOnly(wrong, "sine, chassis.yaw_rate", "has the opposite sign of");
    EXPECT_FALSE(anyOf(wrong.warnings(), "sine, chassis.ay: has the opposite sign"));
    EXPECT_FALSE(anyOf(wrong.warnings(), "sine, driver.steering_wheel_angle: has the opposite sign"));
}

TEST(DataChecks, ARecordingAtRestIsSaidInOneSentence) {
    Case rest = right();
    for (Channel& channel : rest.logs[1].channels) {
        if (channel.name != "time") std::fill(channel.values.begin(), channel.values.end(), 0.0);
    }
    expectOnly(rest, "sine", "the car stands still in the whole recording");
    const auto warnings = rest.warnings();
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [](const DataWarning& one) { return one.where.starts_with("sine"); }),
              1);
}

TEST(DataChecks, ACarOfAnotherScaleIsNamed) {
    Case small = right();
    for (Log& log : small.logs) {
        for (const char* channel : {"chassis.vx", "chassis.ax", "chassis.ay"})
            for (double& value : of(log, channel)) value *= 0.01;
    }
    EXPECT_TRUE(anyOf(small.warnings(), "sine, chassis.vx: over yaw rate gives turns of"));
}

TEST(DataChecks, CommandsInPlaceOfMeasuredInputsAreNamed) {
    Case command = right();
    auto& steer = of(command.logs[2], "driver.steering_wheel_angle");
    for (std::size_t i = 0; i < steer.size(); ++i) steer[i] = i < 110 ? 0 : 0.9;
    expectOnly(command, "step, driver.steering_wheel_angle", "jumps within one sample");
}

TEST(DataChecks, AReferenceOfAnotherCarIsNamed) {
    Case wrong = withReferences();
    for (double& value : of(wrong.references[1], "chassis.yaw_rate")) value *= 1.8;
    for (double& value : of(wrong.references[1], "chassis.ay")) value *= 1.8;
    EXPECT_TRUE(anyOf(wrong.warnings(), "the yaw rate per speed and steering-wheel angle is 1.8 times that"));
}

TEST(DataChecks, SetsThatTellLittleAreNamed) {
    Case one = right();
    one.logs.resize(1);
    one.file.recordings.resize(1);
    expectOnly(one, "all recordings", "only one recording");
    expectOnly(one, "all recordings", "no recording is held out");
    Case same = right();
    same.logs[0] = same.logs[2] = same.logs[1];
    expectOnly(same, "all recordings", "the same manoeuvre");
    Case gentle = right();
    for (Log& log : gentle.logs) {
        for (const char* channel : {"chassis.ay", "chassis.yaw_rate", "chassis.roll", "driver.steering_wheel_angle"})
            for (double& value : of(log, channel)) value *= 0.05;
    }
    expectOnly(gentle, "all recordings", "lateral acceleration never exceeds");
}

}  // namespace
}  // namespace tread::diagnose_data_checks_test
