#include "tread/curve.h"

#include <gtest/gtest.h>

namespace tread {
namespace {

const Curve kCurve{{{1, 10}, {3, 30}, {4, 0}}};

TEST(Curve, PassesThroughItsPoints) {
    for (const Curve::Point& point : kCurve.points) EXPECT_EQ(kCurve(point.x), point.y);
}

TEST(Curve, IsStraightBetweenPoints) {
    EXPECT_DOUBLE_EQ(kCurve(2), 20);
    EXPECT_DOUBLE_EQ(kCurve(1.5), 15);
    EXPECT_DOUBLE_EQ(kCurve(3.75), 7.5);
}

TEST(Curve, IsHeldBeyondBothEnds) {
    EXPECT_EQ(kCurve(-100), 10);
    EXPECT_EQ(kCurve(100), 0);
}

TEST(Curve, OnePointIsAConstantAndNoPointIsZero) {
    const Curve constant{{{2, 7}}};
    EXPECT_EQ(constant(-1), 7);
    EXPECT_EQ(constant(2), 7);
    EXPECT_EQ(constant(9), 7);
    EXPECT_EQ(Curve{}(3), 0);
}

}  // namespace
}  // namespace tread
