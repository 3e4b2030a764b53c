#include <gtest/gtest.h>

#include "base/yaml/read.h"
#include "base/yaml/write.h"
#include "compare/tolerances.h"

namespace tread::compare_tolerances_test {
namespace {

TEST(Tolerances, AFileChangesWhatItNamesAndLeavesTheDefaults) {
    const auto read = readYamlText<Tolerances>(
        "relative: 2 %\n"
        "channels:\n"
        "  - {channel: 'wheel.*.load', absolute: 50}\n"
        "  - {channel: chassis.x, ignore: true}\n",
        "tolerances.yaml");
    EXPECT_DOUBLE_EQ(read.relative, 0.02);
    EXPECT_EQ(read.units.size(), defaultUnitTolerances().size());
    ASSERT_EQ(read.channels.size(), 2u);
    EXPECT_EQ(read.channels[0].absolute, 50);
    EXPECT_FALSE(read.channels[0].relative);
    EXPECT_EQ(allowedDifference(read, {"wheel.front_left.load", "N", {}}).absolute, 50);
    EXPECT_EQ(allowedDifference(read, {"wheel.front_left.load", "N", {}}).relative, 0.02);
    EXPECT_TRUE(allowedDifference(read, {"chassis.x", "m", {}}).ignore);
}

TEST(Tolerances, NegativeTolerancesAndUnknownKeysAreRefused) {
    EXPECT_THROW(readYamlText<Tolerances>("relative: -1\n", "tolerances.yaml"), LoadError);
    EXPECT_THROW(readYamlText<Tolerances>("channels: [{channel: a, absolut: 1}]\n", "tolerances.yaml"), LoadError);
}

TEST(Tolerances, MayHaveUnits) {
    const auto read = readYamlText<Tolerances>(
        "units: [{unit: rad, absolute: 1 deg}]\n"
        "channels: [{channel: chassis.yaw_rate, absolute: 0.2 deg/s}, {channel: chassis.z, absolute: 5 mm}]\n"
        "metrics: [{metric: 'peak_*', absolute: 0.5 km/h, relative: 1 %}]\n",
        "tolerances.yaml");
    constexpr double kDegree = 3.14159265358979 / 180;
    EXPECT_NEAR(allowedDifference(read, {"chassis.yaw_rate", "rad/s", {}}).absolute, 0.2 * kDegree, 1e-12);
    EXPECT_DOUBLE_EQ(allowedDifference(read, {"chassis.z", "m", {}}).absolute, 0.005);
    EXPECT_NEAR(allowedDifference(read, {"chassis.roll", "rad", {}}).absolute, kDegree, 1e-12);
    EXPECT_DOUBLE_EQ(allowedDifference(read, "peak_speed", "m/s").absolute, 0.5 / 3.6);
    EXPECT_DOUBLE_EQ(allowedDifference(read, "peak_speed", "m/s").relative, 0.01);
    EXPECT_DOUBLE_EQ(allowedDifference(read, "duration", "s").relative, 0.005);
    EXPECT_NEAR(allowedDifference(read, "largest_roll", "deg").absolute, 1, 1e-12) << "the least difference in rad";
    EXPECT_DOUBLE_EQ(allowedDifference(Tolerances{}, "deviation", "m").absolute, 1e-3);
    EXPECT_TRUE(unitFaults(read, {{{"time", "s", {}}, {"chassis.z", "m", {}}}}).empty());
    const auto faults = unitFaults(read, {{{"time", "s", {}}, {"chassis.z", "rad", {}}}});
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].path, "channels.1.absolute");
    EXPECT_FALSE(unitFault(read, "peak_speed", "m/s"));
    EXPECT_EQ(unitFault(read, "peak_ay", "m/s2")->path, "metrics.0.absolute");
}

TEST(Tolerances, WhatIsReadIsWrittenBack) {
    const auto read = readYamlText<Tolerances>("channels: [{channel: chassis.yaw_rate, absolute: 0.2 deg/s}]\n", "a");
    EXPECT_EQ(readYamlText<Tolerances>(writeYaml(read), "b").channels[0].absolute, Quantity(0.2, "deg/s"));
}

TEST(Tolerances, UnknownAndUnfittingUnitsAreRefused) {
    for (const char* text :
         {"channels: [{channel: a, absolute: 1 furlong}]\n", "units: [{unit: rad, absolute: 1 kg}]\n",
          "units: [{unit: rad}]\n", "channels: [{channel: a, absolute: -1 m}]\n"})
        EXPECT_THROW(readYamlText<Tolerances>(text, "tolerances.yaml"), LoadError) << text;
}

}  // namespace
}  // namespace tread::compare_tolerances_test
