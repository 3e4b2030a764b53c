#include "tread/curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::curve_test {
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

TEST(Curve, OfNoNumberIsNoNumber) {
    EXPECT_TRUE(std::isnan(kCurve(std::nan(""))));
    EXPECT_TRUE(std::isnan(Curve{{{2, 7}}}(std::nan(""))));
}

}  // namespace
}  // namespace tread::curve_test
