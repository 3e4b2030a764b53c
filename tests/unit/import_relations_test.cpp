// What the channels of a rigid body say of one another: the odd one out, and channels in each other's place.
#include "import/relations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "import/doubts.h"
#include "shared/foreign_logs.h"

namespace tread::import_relations_test {
namespace {

using Signal = std::function<double(double)>;

double speed(double t) {
    return 20 + 3 * std::sin(0.7 * t);
}
double gain(double t) {
    return 3 * 0.7 * std::cos(0.7 * t);
}
double yawRate(double t) {
    return 0.25 * std::sin(2 * t);
}
double lateral(double t) {
    return speed(t) * yawRate(t);
}

// A car that follows its steering wheel at once and rolls by 0.008 rad per m/s2; ISO 8855.
Log car() {
    const std::vector<std::pair<std::string, Signal>> signals = {
        {"time", [](double t) { return t; }},
        {"driver.steering_wheel_angle", [](double t) { return 3 * yawRate(t); }},
        {"chassis.vx", speed},
        {"chassis.yaw_rate", yawRate},
        {"chassis.ax", gain},
        {"chassis.ay", lateral},
        {"chassis.roll", [](double t) { return 0.008 * lateral(t); }},
        {"chassis.pitch", [](double t) { return -0.01 * gain(t); }},
        {"wheel.front_left.spin", [](double t) { return speed(t) / 0.32; }}};
    Log log;
    for (const auto& [name, value] : signals) {
        log.channels.push_back({name, "-", {}});
        for (const double t : foreign::times(1001)) log.channels.back().values.push_back(value(t));
    }
    return log;
}

Channel& channel(Log& log, const std::string& name) {
    return *std::find_if(log.channels.begin(), log.channels.end(), [&](const Channel& c) { return c.name == name; });
}

Log turned(const std::vector<std::string>& names) {
    Log log = car();
    for (const std::string& name : names) {
        for (double& value : channel(log, name).values) value = -value;
    }
    return log;
}

std::string said(const Log& log) {
    return text(doubts(log));
}

TEST(BodyRelations, OfACarAgree) {
    EXPECT_GE(bodyRelations(car()).size(), 8u);
    EXPECT_EQ(said(car()), "");
}

TEST(BodyRelations, TheOddOneOutIsNamed) {
    for (const char* name : {"driver.steering_wheel_angle", "chassis.yaw_rate", "chassis.ay", "chassis.ax",
                             "chassis.roll", "chassis.pitch", "wheel.front_left.spin"}) {
        const OddOnes odd = oddOnes(bodyRelations(turned({name})));
        EXPECT_EQ(odd.turned, std::vector<std::string>{name});
        EXPECT_TRUE(odd.either.empty()) << name;
        EXPECT_NE(said(turned({name})).find(std::string(name) + ": is the odd one out: "), std::string::npos) << name;
    }
    EXPECT_EQ(oddOnes(bodyRelations(turned({"chassis.ax", "chassis.yaw_rate"}))).turned.size(), 2u);
}

TEST(BodyRelations, WithoutAMajorityBothAreNamed) {
    Log log = turned({"chassis.ay"});
    std::erase_if(log.channels, [](const Channel& c) {
        return c.name != "time" && c.name != "chassis.vx" && c.name != "chassis.ay" && c.name != "chassis.yaw_rate";
    });
    const OddOnes odd = oddOnes(bodyRelations(log));
    EXPECT_TRUE(odd.turned.empty());
    EXPECT_EQ(odd.either.size(), 2u);
    EXPECT_NE(said(log).find("one of chassis.ay and chassis.yaw_rate has the wrong sign, and no other channel shows"),
              std::string::npos)
        << said(log);
}

TEST(BodyRelations, ChannelsInEachOthersPlaceAreNamed) {
    Log gyro = car();
    std::swap(channel(gyro, "chassis.yaw_rate").values, channel(gyro, "chassis.ay").values);
    EXPECT_EQ(said(gyro).find("chassis.yaw_rate: seems swapped with chassis.ay ("), 0u) << said(gyro);
    Log axes = car();
    std::swap(channel(axes, "chassis.ax").values, channel(axes, "chassis.ay").values);
    EXPECT_EQ(said(axes).find("chassis.ax: seems swapped with chassis.ay ("), 0u) << said(axes);
}

// As a guess takes them: m/s2 for deg/s, rad/s for g.
TEST(BodyRelations, ChannelsInEachOthersPlaceAreNamedWhateverTheirUnit) {
    Log gyro = car();
    std::swap(channel(gyro, "chassis.yaw_rate").values, channel(gyro, "chassis.ay").values);
    for (double& value : channel(gyro, "chassis.yaw_rate").values) value *= foreign::kDegree;
    for (double& value : channel(gyro, "chassis.ay").values) value *= foreign::kGravity;
    EXPECT_EQ(said(gyro).find("chassis.yaw_rate: seems swapped with chassis.ay ("), 0u) << said(gyro);
}

// At 7.5 m/s a yaw rate in degrees is as large against vx times ay as one that was swapped.
TEST(BodyRelations, AYawRateInDegreesIsNotSwapped) {
    Log log = car();
    for (double& value : channel(log, "chassis.vx").values) value = 7.5;
    for (std::size_t i = 0; i < log.samples(); ++i) {
        const double rate = yawRate(log.channels.front().values[i]);
        channel(log, "chassis.yaw_rate").values[i] = rate / foreign::kDegree;
        channel(log, "chassis.ay").values[i] = 7.5 * rate;
    }
    EXPECT_EQ(said(log).find("swapped"), std::string::npos) << said(log);
    EXPECT_NE(said(log).find("as if one of them were in degrees"), std::string::npos) << said(log);
}

TEST(BodyRelations, AWrongUnitIsSeenAlongTheCarToo) {
    Log log = car();
    for (double& value : channel(log, "chassis.ax").values) value /= foreign::kGravity;
    EXPECT_NE(said(log).find("chassis.ax and the derivative of chassis.vx differ by a factor of 0.10"),
              std::string::npos)
        << said(log);
}

TEST(BodyRelations, WheelsThatDoNotRollAreDoubted) {
    Log log = car();
    for (double& value : channel(log, "wheel.front_left.spin").values) value *= 60 / 6.2832;  // rpm taken as rad/s
    EXPECT_NE(said(log).find("wheel.front_left.spin: turns as if its rolling radius were 0.0335 m"), std::string::npos)
        << said(log);
}

TEST(Doubts, ValuesBeyondARoadVehicleAreSaid) {
    Log log = car();
    std::erase_if(log.channels, [](const Channel& c) { return c.name != "time" && c.name != "chassis.yaw_rate"; });
    Channel& yaw_rate = channel(log, "chassis.yaw_rate");
    yaw_rate.unit = "rad/s";
    EXPECT_EQ(said(log), "");
    for (double& value : yaw_rate.values) value *= 57.3;
    EXPECT_EQ(said(log),
              "chassis.yaw_rate: values peak at 14.3 rad/s, above the 3.2 that a road vehicle reaches; is its unit "
              "wrong?\n");
}

}  // namespace
}  // namespace tread::import_relations_test
