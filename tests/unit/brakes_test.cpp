#include "tread/brakes.h"

#include <gtest/gtest.h>

namespace tread {
namespace {

TEST(Brakes, FourWheelsTogetherGiveTheFullTorqueAtFullPedal) {
    const PerAxle<double> wheel = brakeTorques({.full_pedal_torque = 5000, .front_share = 0.7}, 1);
    EXPECT_DOUBLE_EQ(2 * wheel.front + 2 * wheel.rear, 5000);
    EXPECT_DOUBLE_EQ(2 * wheel.front, 3500);
}

TEST(Brakes, TorqueIsProportionalToThePedal) {
    const BrakeParams p{.full_pedal_torque = 5000, .front_share = 0.7};
    EXPECT_EQ(brakeTorques(p, 0).front, 0);
    EXPECT_EQ(brakeTorques(p, 0).rear, 0);
    EXPECT_DOUBLE_EQ(brakeTorques(p, 0.25).front, 0.25 * brakeTorques(p, 1).front);
    EXPECT_DOUBLE_EQ(brakeTorques(p, 0.25).rear, 0.25 * brakeTorques(p, 1).rear);
}

}  // namespace
}  // namespace tread
