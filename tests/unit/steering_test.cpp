#include "tread/steering.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread {
namespace {

constexpr double kTrack = 1.5, kWheelbase = 2.6;

TEST(Steering, WithoutAckermannBothWheelsTurnByTheHandWheelOverTheRatio) {
    const SteeringParams p{.ratio = 16, .ackermann = 0};
    for (const double hand : {-4.0, 0.0, 1.6}) {
        const RoadWheelAngles wheels = roadWheelAngles(p, hand, kTrack, kWheelbase);
        EXPECT_EQ(wheels.left, hand / 16);
        EXPECT_EQ(wheels.right, hand / 16);
    }
}

TEST(Steering, FullAckermannPointsBothAxlesAtOneCentre) {
    const SteeringParams p{.ratio = 16, .ackermann = 1};
    for (const double hand : {-7.0, -0.5, 0.5, 3.0, 7.0}) {
        const RoadWheelAngles wheels = roadWheelAngles(p, hand, kTrack, kWheelbase);
        // The normal of each wheel meets the rear axle's line at the same distance to the left.
        const double from_left = kWheelbase / std::tan(wheels.left) + 0.5 * kTrack;
        const double from_right = kWheelbase / std::tan(wheels.right) - 0.5 * kTrack;
        EXPECT_NEAR(from_left, from_right, 1e-9);
        EXPECT_NEAR(from_left, kWheelbase / std::tan(hand / 16), 1e-9);
        EXPECT_GT(std::abs(hand > 0 ? wheels.left : wheels.right), std::abs(hand > 0 ? wheels.right : wheels.left))
            << "the inner wheel turns more";
    }
}

TEST(Steering, LeftAndRightMirrorEachOther) {
    const SteeringParams p{.ratio = 15, .ackermann = 0.6};
    const RoadWheelAngles left = roadWheelAngles(p, 2, kTrack, kWheelbase);
    const RoadWheelAngles right = roadWheelAngles(p, -2, kTrack, kWheelbase);
    EXPECT_DOUBLE_EQ(left.left, -right.right);
    EXPECT_DOUBLE_EQ(left.right, -right.left);
}

TEST(Steering, NoAngleAtTheCentreForAnyAckermann) {
    for (const double ackermann : {-0.5, 0.0, 0.5, 1.0}) {
        const RoadWheelAngles wheels = roadWheelAngles({.ratio = 15, .ackermann = ackermann}, 0, kTrack, kWheelbase);
        EXPECT_EQ(wheels.left, 0);
        EXPECT_EQ(wheels.right, 0);
    }
}

}  // namespace
}  // namespace tread
