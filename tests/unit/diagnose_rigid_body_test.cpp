// Agreement of channels as motion of one rigid body: exact motion agrees, errors of instruments are found with their
// size, and what no instrument explains is put down to the channel that is odd.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/math/random.h"
#include "recording/checks/rigid_body.h"
#include "recording/checks/windows.h"
#include "recording/position.h"

namespace tread::diagnose_rigid_body_test {
namespace {

using recording::Contradictions;
using recording::DiagnosisFile;
using recording::Instruments;
using recording::Recorded;
using recording::checks::Agreement;
using recording::checks::agreements;
using recording::checks::InstrumentError;
using recording::checks::leaveOutContradictions;
using recording::checks::oddChannel;
using recording::checks::Windows;
using Kind = InstrumentError::Kind;

// A motion of several frequencies, so that delay, gain and place are told apart. Its derivatives are exact.
double yawRate(double t) {
    return 0.25 * std::sin(1.3 * t) + 0.1 * std::sin(3.1 * t + 1);
}
double yawAcceleration(double t) {
    return 0.25 * 1.3 * std::cos(1.3 * t) + 0.1 * 3.1 * std::cos(3.1 * t + 1);
}
double heading(double t) {
    return -0.25 / 1.3 * std::cos(1.3 * t) - 0.1 / 3.1 * std::cos(3.1 * t + 1);
}
double speed(double t) {
    return 15 + 4 * std::sin(0.7 * t);
}
double acrossSpeed(double t) {
    return 0.5 * std::sin(1.7 * t) + 0.3 * std::sin(2.9 * t);
}
double acrossRate(double t) {
    return 0.5 * 1.7 * std::cos(1.7 * t) + 0.3 * 2.9 * std::cos(2.9 * t);
}

using Signal = std::function<double(double)>;

void add(Log& log, const char* name, const char* unit, const Signal& signal, double noise, std::uint64_t seed) {
    Random random(seed);
    Channel channel{name, unit, {}};
    for (const double t : log.channels[0].values) channel.values.push_back(signal(t) + noise * random.normal());
    log.channels.push_back(std::move(channel));
}

double ay(double t) {
    return acrossRate(t) + speed(t) * yawRate(t);
}

// 30 s at 100 Hz with the noise of usual instruments, each signal as given.
Log recorded(const Signal& shown_ay = ay, const Signal& shown_vy = acrossSpeed, const Signal& shown_rate = yawRate) {
    Log log{{{"time", "s", {}}}};
    for (int i = 0; i <= 3000; ++i) log.channels[0].values.push_back(i / 100.0);
    add(log, "chassis.vx", "m/s", speed, 0.02, 1);
    add(log, "chassis.vy", "m/s", shown_vy, 0.02, 2);
    add(log, "chassis.yaw_rate", "rad/s", shown_rate, 0.003, 3);
    add(log, "chassis.ay", "m/s2", shown_ay, 0.1, 4);
    add(
        log, "chassis.ax", "m/s2", [](double t) { return 2.8 * std::cos(0.7 * t) - acrossSpeed(t) * yawRate(t); }, 0.1,
        5);
    return log;
}

Agreement of(const std::vector<Agreement>& all, const std::string& channel) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Agreement& one) { return one.channel == channel; });
    return found == all.end() ? Agreement{} : *found;
}

void expectError(const Agreement& said, Kind kind, double size, double tolerance) {
    ASSERT_EQ(said.errors.size(), 1u) << toText(said);
    EXPECT_EQ(said.errors[0].kind, kind) << toText(said);
    EXPECT_NEAR(said.errors[0].size, size, tolerance) << toText(said);
    EXPECT_FALSE(said.contradicts) << toText(said);
    EXPECT_LT(said.left, 0.6 * said.apart) << toText(said);
}

TEST(Windows, RateIsTheMeanOfTheDerivative) {
    std::vector<double> time, values, derivative;
    for (int i = 0; i < 500; ++i) {
        time.push_back(i / 100.0);
        values.push_back(std::sin(3 * time.back()));
        derivative.push_back(3 * std::cos(3 * time.back()));
    }
    const Windows windows(time);
    const std::vector<double> rate = windows.rate(windows.blocks(values)),
                              mean = windows.mean(windows.blocks(derivative));
    for (std::size_t k = 1; k + 20 < rate.size(); ++k) EXPECT_NEAR(rate[k], mean[k], 0.002);
    EXPECT_TRUE(std::isnan(rate.front()) && std::isnan(mean.back())) << "windows that reach beyond the ends";
}

TEST(RigidBody, ExactMotionAgrees) {
    const std::vector<Agreement> all = agreements(recorded(), {});
    ASSERT_EQ(all.size(), 2u);
    for (const Agreement& one : all) {
        EXPECT_TRUE(one.errors.empty()) << toText(one);
        EXPECT_FALSE(one.contradicts) << toText(one);
    }
    EXPECT_EQ(oddChannel(all), "");
}

TEST(RigidBody, ErrorsOfTheAccelerometerHaveTheirSize) {
    const auto ay_of = [](const Signal& shown) { return of(agreements(recorded(shown), {}), "chassis.ay"); };
    expectError(ay_of([](double t) { return ay(t - 0.08); }), Kind::delay, 0.08, 0.005);
    expectError(ay_of([](double t) { return ay(t - 0.4); }), Kind::delay, 0.4, 0.01);
    expectError(ay_of([](double t) { return 1.08 * ay(t); }), Kind::gain, 0.08, 0.005);
    expectError(ay_of([](double t) { return ay(t) + 0.5; }), Kind::bias, 0.5, 0.02);
    expectError(ay_of([](double t) { return ay(t) + 0.8 * yawAcceleration(t); }), Kind::place, 0.8, 0.05);
}

TEST(RigidBody, ShortOrReversedRecordingsAreNotJudged) {
    Log brief = recorded();
    for (Channel& channel : brief.channels) channel.values.resize(120);
    EXPECT_TRUE(agreements(brief, {}).empty());
    for (const Agreement& one : agreements(recorded([](double t) { return -ay(t); }), {})) {
        EXPECT_TRUE(one.errors.empty()) << toText(one);
        EXPECT_FALSE(one.contradicts) << toText(one);
    }
}

TEST(RigidBody, GainIsReadAsBodyRoll) {
    const std::vector<Agreement> all = agreements(recorded([](double t) { return 1.08 * ay(t); }), {});
    EXPECT_NE(toText(of(all, "chassis.ay")).find("body roll of 4.6 deg per g"), std::string::npos)
        << toText(of(all, "chassis.ay"));
}

TEST(RigidBody, WhatTheFileStatesIsTakenOut) {
    Instruments known;
    known.ay = {.gain = 1.1, .bias = 0.4, .delay = 0.1};
    const Log log = recorded([](double t) { return 1.1 * ay(t - 0.1) + 0.4; });
    EXPECT_EQ(of(agreements(log, {}), "chassis.ay").errors.size(), 3u);
    EXPECT_TRUE(of(agreements(log, known), "chassis.ay").errors.empty());
}

TEST(RigidBody, LateGyroIsFoundAgainstTheHeading) {
    Log log = recorded(ay, acrossSpeed, [](double t) { return yawRate(t - 0.08); });
    std::erase_if(log.channels, [](const Channel& one) { return one.name == "chassis.ay"; });
    add(log, "position.heading", "rad", heading, 1e-4, 9);
    recording::addVelocities(log);
    const Agreement said = of(agreements(log, {}), "chassis.yaw_rate@position");
    expectError(said, Kind::delay, 0.08, 0.005);
    EXPECT_EQ(said.errors.at(0).channel, "chassis.yaw_rate") << "of two instruments the late one is named";
}

TEST(RigidBody, LateralVelocityThatContradictsIsTheOddOne) {
    // Its phase is wrong at one frequency and right at the other, as after a filter.
    const Log log =
        recorded(ay, [](double t) { return 0.5 * std::sin(1.7 * t + 1.2) + 0.3 * std::sin(2.9 * t - 1.5); });
    const std::vector<Agreement> all = agreements(log, {});
    EXPECT_TRUE(of(all, "chassis.ay").contradicts) << toText(of(all, "chassis.ay"));
    EXPECT_GT(of(all, "chassis.ay").left, 0.4);
    EXPECT_EQ(oddChannel(all), "chassis.vy");
}

TEST(RigidBody, AccelerationThatContradictsIsTheOddOne) {
    Log log = recorded([](double t) { return ay(t) + std::sin(2.3 * t); });
    add(log, "chassis.ay@can", "m/s2", ay, 0.1, 12);
    EXPECT_EQ(oddChannel(agreements(log, {})), "chassis.ay");
}

TEST(RigidBody, OddChannelIsLeftOutUnlessTheFileKeepsIt) {
    DiagnosisFile file;
    const Log wrong =
        recorded(ay, [](double t) { return 0.5 * std::sin(1.7 * t + 1.2) + 0.3 * std::sin(2.9 * t - 1.5); });
    Recorded logs{.logs = {wrong, wrong, recorded()}, .references = {Log{}, Log{}, Log{}}};
    file.contradictions = Contradictions::keep;
    EXPECT_TRUE(leaveOutContradictions(file, logs).empty());
    EXPECT_TRUE(logs.logs[0].find("chassis.vy"));
    file.contradictions = Contradictions::leave_out;
    const std::vector<std::string> said = leaveOutContradictions(file, logs);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("chassis.vy is left out: it contradicts the other channels in 2 of 3"), std::string::npos);
    for (const Log& log : logs.logs) EXPECT_EQ(log.find("chassis.vy"), nullptr);
    Recorded mostly{.logs = {wrong, recorded(), recorded()}, .references = {Log{}, Log{}, Log{}}};
    EXPECT_TRUE(leaveOutContradictions(file, mostly).empty())
        << "one bad recording of three does not condemn a channel";
}

TEST(RigidBody, ChannelsThatAreNotUsedContradictNothing) {
    const Log wrong =
        recorded(ay, [](double t) { return 0.5 * std::sin(1.7 * t + 1.2) + 0.3 * std::sin(2.9 * t - 1.5); });
    DiagnosisFile file;
    file.channels = {{.channel = "chassis.vx"},
                     {.channel = "chassis.yaw_rate"},
                     {.channel = "chassis.ay"},
                     {.channel = "chassis.ax"}};
    Recorded logs{.logs = {wrong}, .references = {Log{}}};
    EXPECT_TRUE(leaveOutContradictions(file, logs).empty()) << "lateral velocity is not listed";
    logs.before = {wrong};
    file.channels.push_back({.channel = "chassis.vy"});
    EXPECT_EQ(leaveOutContradictions(file, logs).size(), 1u);
    EXPECT_EQ(logs.before[0].find("chassis.vy"), nullptr) << "left out of all drives";
}

}  // namespace
}  // namespace tread::diagnose_rigid_body_test
