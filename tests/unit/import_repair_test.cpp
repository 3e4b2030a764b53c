// What is wrong with the time base and the values of a foreign log is repaired, and counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "import/import.h"
#include "import/spikes.h"
#include "import/time_base.h"
#include "shared/foreign_logs.h"
#include "shared/import_problems.h"

namespace tread::import_repair_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Sorted {
    std::vector<Stretch> recordings;
    std::vector<Change> changes;

    std::size_t count(const std::string& kind) const {
        std::size_t sum = 0;
        for (const Change& change : changes) sum += change.kind == kind ? change.count : 0;
        return sum;
    }
};

Sorted sorted(const std::vector<double>& time, const ImportRepairs& repairs = {}) {
    Sorted result;
    result.recordings = recordingsOf(time, {"x.csv", "text table", {}, {}, {}}, repairs, result.changes);
    return result;
}

ImportRepairs repairsAt(AtJump at_jump) {
    ImportRepairs repairs;
    repairs.at_jump = at_jump;
    return repairs;
}

TEST(TimeBase, IsUntouchedWhenThereIsNothingToRepair) {
    const Sorted result = sorted(foreign::times());
    ASSERT_EQ(result.recordings.size(), 1u);
    EXPECT_EQ(result.recordings[0].time, foreign::times());
    EXPECT_TRUE(result.changes.empty());
}

TEST(TimeBase, RepeatedAndEarlierStampsAreDropped) {
    const Sorted result = sorted({5, 5.01, 5.01, 5.02, 5.015, 5.03, kNan, 5.04});
    ASSERT_EQ(result.recordings.size(), 1u);
    EXPECT_EQ(result.recordings[0].rows, (std::vector<std::size_t>{0, 1, 3, 5, 7}));
    EXPECT_EQ(result.count("duplicates"), 1u);
    EXPECT_EQ(result.count("backwards"), 1u);
    EXPECT_EQ(result.count("without_time"), 1u);
    EXPECT_NE(text(result.changes).find("1 row with a repeated time stamp dropped (the first at sample 3)"),
              std::string::npos);
}

TEST(TimeBase, StampsThatAreTheSameAfterTheFirstAreRepeated) {
    const Sorted result = sorted({-0.125, 1e-18, 2e-18, 0.125});
    ASSERT_EQ(result.recordings.size(), 1u);
    EXPECT_EQ(result.recordings[0].rows, (std::vector<std::size_t>{0, 1, 3}));
    EXPECT_EQ(result.recordings[0].time, (std::vector<double>{0, 0.125, 0.25}));
    EXPECT_EQ(result.count("duplicates"), 1u);
}

TEST(TimeBase, SamplesMissingInAGapAreCountedWithinReason) {
    EXPECT_NE(text(sorted({0, 1e-200, 2e-200, 1}).changes).find("about 999999999 samples missing"), std::string::npos);
}

TEST(TimeBase, AJumpEndsARecordingAndTheLongestIsKept) {
    std::vector<double> time = foreign::times(100);
    for (int i = 0; i < 300; ++i) time.push_back(50 + 0.01 * i);
    time.push_back(7);
    const Sorted kept = sorted(time);
    ASSERT_EQ(kept.recordings.size(), 1u);
    EXPECT_EQ(kept.recordings[0].rows.front(), 100u);
    EXPECT_EQ(kept.recordings[0].rows.size(), 300u);
    EXPECT_EQ(kept.recordings[0].begin, 50);
    EXPECT_EQ(kept.count("jump"), 101u);

    const Sorted split = sorted(time, repairsAt(AtJump::split));
    ASSERT_EQ(split.recordings.size(), 3u);
    EXPECT_EQ(split.recordings[0].rows.size(), 100u);
    EXPECT_EQ(faultsOf([&] { sorted(time, repairsAt(AtJump::refuse)); }),
              "x.csv: time jumps by +49.01 s at sample 101, expected one recording (repairs.at_jump: longest keeps the "
              "longest, split all)");
}

TEST(TimeBase, OneWildStampDoesNotTearARecording) {
    std::vector<double> time = foreign::times();
    time[250] = 1e6;
    const Sorted result = sorted(time);
    ASSERT_EQ(result.recordings.size(), 1u);
    EXPECT_EQ(result.recordings[0].rows.size(), 500u);
    EXPECT_EQ(result.count("wild_time"), 1u);
    EXPECT_EQ(result.count("jump"), 0u);
}

TEST(TimeBase, GapsAndUnevenStepsAreSaid) {
    std::vector<double> time = foreign::times();
    time.erase(time.begin() + 100, time.begin() + 120);
    time[50] += 0.004;
    const Sorted result = sorted(time);
    EXPECT_EQ(result.recordings[0].rows.size(), 481u);
    EXPECT_EQ(result.count("gaps"), 1u);
    EXPECT_EQ(result.count("uneven"), 2u);
    EXPECT_NE(text(result.changes).find("1 gap in time, about 20 samples missing, the longest step 0.21 s"),
              std::string::npos)
        << text(result.changes);
}

std::vector<double> sampled(double (*value)(double)) {
    std::vector<double> values;
    for (const double t : foreign::times()) values.push_back(value(t));
    return values;
}

TEST(Spikes, AreReplacedByWhatLiesBetweenTheirNeighbours) {
    const std::vector<double> time = foreign::times(), clean = sampled(foreign::yawRate);
    for (const std::size_t length : {1u, 2u, 3u}) {
        for (const double height : {0.2, -5.0, 1e6}) {
            std::vector<double> values = clean;
            for (std::size_t k = 0; k < length; ++k) values[200 + k] += height;
            const auto replaced = replaceSpikes(time, values, 12);
            ASSERT_EQ(replaced.size(), length) << height;
            EXPECT_EQ(replaced.front(), 200u);
            for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], clean[i], 5e-4) << i;
        }
    }
}

TEST(Spikes, WhatACarDoesIsNone) {
    const std::vector<double> time = foreign::times();
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 1);
    for (const auto& [name, value] : std::vector<std::pair<const char*, std::function<double(double)>>>{
             {"noise", [&](double) { return noise(random); }},
             {"sine of 8 Hz", [](double t) { return std::sin(50 * t); }},
             {"step in one sample", [](double t) { return t < 2 ? 0.01 * t : 3 + 0.01 * t; }},
             {"pulse of 50 ms", [](double t) { return t > 2 && t < 2.05 ? 5 : 0.01 * t; }},
             {"switch", [](double t) { return t == 2 ? 1 : 0; }},
             {"quantised", [&](double) { return 0.5 * std::round(0.6 * noise(random)) + 20; }}}) {
        std::vector<double> values;
        for (const double t : time) values.push_back(value(t));
        EXPECT_TRUE(replaceSpikes(time, values, 12).empty()) << name;
    }
}

// The steering angle of a driver, with what no hand can do: 50 rad/s is the fastest.
constexpr SpikeCriterion kHand{.limit = 12, .fastest = 50, .longest = 1};

TEST(Spikes, OfAnyLengthThatACarCannotDoAreReplaced) {
    const std::vector<double> time = foreign::times(), clean = sampled(foreign::steering);
    for (const std::size_t length : {1u, 3u, 5u, 40u, 90u}) {
        for (const double height : {3.0, -141.0, 1e6}) {
            std::vector<double> values = clean;
            for (std::size_t k = 0; k < length; ++k)
                values[200 + k] += height * (1 + 0.1 * std::sin(7.0 * static_cast<double>(k)));
            const auto replaced = replaceSpikes(time, values, kHand);
            ASSERT_EQ(replaced.size(), length) << height;
            EXPECT_EQ(replaced.front(), 200u);
            const double bend =
                0.5 * 4 * std::pow(0.005 * static_cast<double>(length + 1), 2);  // of a sine from its chord
            for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], clean[i], bend) << i;
        }
    }
}

TEST(Spikes, LongOnesLeaveAHoleBecauseNothingWasMeasured) {
    const std::vector<double> time = foreign::times();
    std::vector<double> values = sampled(foreign::steering);
    for (std::size_t k = 100; k < 250; ++k) values[k] = 141;
    EXPECT_EQ(replaceSpikes(time, values, kHand).size(), 150u);
    for (std::size_t k = 100; k < 250; ++k) EXPECT_TRUE(std::isnan(values[k])) << k;
    EXPECT_NEAR(values[250], foreign::steering(2.5), 1e-12);
}

TEST(Spikes, APlateauThatACarCanReachStays) {
    const std::vector<double> time = foreign::times();
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 0.5);
    const auto ramp = [](double t, double from, double to, double rate) {
        return std::clamp(rate * (t - from), 0.0, 4.0) - std::clamp(rate * (t - to), 0.0, 4.0);
    };
    for (const auto& [name, value] : std::vector<std::pair<const char*, std::function<double(double)>>>{
             {"fast hand", [&](double t) { return ramp(t, 1, 1.5, 20); }},
             {"robot", [&](double t) { return ramp(t, 1, 1.2, 45); }},
             {"held for 50 ms", [&](double t) { return ramp(std::floor(20 * t + 1e-6) / 20, 1, 1.2, 30); }},
             {"jump that stays", [](double t) { return t < 2 ? 0.1 * std::sin(t) : 5 + 0.1 * std::sin(t); }},
             {"jump that comes back slowly",
              [](double t) { return t < 2 ? 0 : std::max(0.0, 5 - 10 * (t - 2)) + 1e-3 * std::sin(t); }},
             {"another drive put in", [](double t) { return std::sin(t) + (t > 1 && t < 3 ? 5 : 0); }},
             {"noise", [&](double) { return noise(random); }}}) {
        std::vector<double> values;
        for (const double t : time) values.push_back(value(t));
        EXPECT_TRUE(replaceSpikes(time, values, kHand).empty()) << name;
    }
}

// 10 Hz: a pulse of one sample is what a driver does, one of 3 m/s within 0.1 s is what a car does.
TEST(Spikes, ThreeSamplesOfASlowLogAreNoSpike) {
    const std::vector<double> time = foreign::times(101, 0.1);
    std::vector<double> values;
    for (const double t : time) values.push_back(0.1 * std::sin(t));
    values[50] = 3;
    EXPECT_TRUE(replaceSpikes(time, values, kHand).empty());
    values[50] = 9;
    EXPECT_EQ(replaceSpikes(time, values, kHand), std::vector<std::size_t>{50});
}

TEST(Holes, AreFilledUpToTheLongestAndNeverAtTheEnds) {
    const std::vector<double> time{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    std::vector<double> values{kNan, 1, kNan, 3, kNan, kNan, kNan, 7, 8, kNan};
    EXPECT_EQ(fillHoles(time, values, 2.5), 1u);
    EXPECT_EQ(values[2], 2);
    EXPECT_TRUE(std::isnan(values[4]) && std::isnan(values[0]) && std::isnan(values[9]));
    EXPECT_EQ(fillHoles(time, values, 4), 3u);
    EXPECT_EQ(values[5], 5);
}

TEST(ImportRepairs, SpikesAreCountedWithTheirCriterion) {
    ForeignTable table{"x.csv", "text table", {}, {}, {}};
    table.columns.push_back({"t", "s", foreign::times(), 0, 0, {}});
    table.columns.push_back({"a", "rad", sampled(foreign::steering), 0, 0, {}});
    for (std::size_t i = 100; i < 105; ++i) table.columns[1].values[i] = 141;
    for (std::size_t i = 300; i < 307; ++i) table.columns[1].values[i] = -141;
    ImportMap map;
    map.time.from = "t";
    map.map.resize(1);
    map.map[0].channel = "driver.steering_wheel_angle";
    map.map[0].from = "a";
    const Imported result = importLog(table, map);
    EXPECT_EQ(text(result.changes)
                  .find("driver.steering_wheel_angle: 12 samples in 2 spikes replaced (the first at 1 s: "
                        "141 instead of about 0.45"),
              0u)
        << text(result.changes);
    EXPECT_NE(text(result.changes).find("faster than the 50 rad/s that a car can do"), std::string::npos);
    EXPECT_NEAR(valuesOf(result.logs[0], "driver.steering_wheel_angle")[102], foreign::steering(1.02), 1e-2);
}

TEST(ImportRepairs, CanBeSwitchedOff) {
    ForeignTable table{"x.csv", "text table", {}, {}, {}};
    table.columns.push_back({"t", "s", foreign::times(), 0, 0, {}});
    table.columns.push_back({"r", "rad/s", sampled(foreign::yawRate), 0, 0, {}});
    table.columns[1].values[100] = 9;
    table.columns[1].values[200] = kNan;
    ImportMap map;
    map.time.from = "t";
    map.map.resize(1);
    map.map[0].channel = "chassis.yaw_rate";
    map.map[0].from = "r";
    const auto at = [&](std::size_t i) { return valuesOf(importLog(table, map).logs[0], "chassis.yaw_rate")[i]; };
    EXPECT_NEAR(at(100), foreign::yawRate(1), 1e-3);
    EXPECT_NEAR(at(200), foreign::yawRate(2), 1e-3);
    map.repairs.fill_gaps = false;
    EXPECT_TRUE(std::isnan(at(200)));
    map.map[0].spikes = false;
    EXPECT_EQ(at(100), 9);
    map.map[0].spikes = true;
    map.repairs.spikes = false;
    EXPECT_EQ(at(100), 9);
}

}  // namespace
}  // namespace tread::import_repair_test
