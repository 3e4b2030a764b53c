#include "log/direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tread::direction_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Direction, IsCountedOnBeyondATurnBothWays) {
    const std::vector<double> angles = continuous({3, -3, -2.9, 3, 3.1});
    const double expected[] = {3, 2 * kPi - 3, 2 * kPi - 2.9, 3, 3.1};
    for (std::size_t i = 0; i < angles.size(); ++i) EXPECT_NEAR(angles[i], expected[i], 1e-14) << i;
    EXPECT_NEAR(continuous({6.2, 0.1, 6.2, 0.1, 3, 6, 0.1}).back(), 4 * kPi + 0.1, 1e-14);
}

TEST(Direction, WhatIsMissingDoesNotSpread) {
    const std::vector<double> angles = continuous({std::nan(""), 3, std::nan(""), -3});
    EXPECT_TRUE(std::isnan(angles[0]));
    EXPECT_EQ(angles[1], 3);
    EXPECT_TRUE(std::isnan(angles[2]));
    EXPECT_NEAR(angles[3], 2 * kPi - 3, 1e-14);
}

TEST(Direction, OnlyDirectionsInThePlaneAre) {
    EXPECT_TRUE(isDirection("chassis.yaw"));
    EXPECT_TRUE(isDirection("position.heading@gps"));
    EXPECT_FALSE(isDirection("driver.steering_wheel_angle"));
    EXPECT_FALSE(isDirection("chassis.yaw_rate"));
}

}  // namespace
}  // namespace tread::direction_test
