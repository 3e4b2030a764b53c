#include "scenario/condition.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::condition_test {
namespace {

bool meets(double value, const std::string& condition, const std::string& unit) {
    std::string fault;
    const auto parsed = parseCondition(condition, fault);
    EXPECT_TRUE(parsed) << fault;
    const auto interval = intervalOf(*parsed, unit, fault);
    EXPECT_TRUE(interval) << fault;
    return interval && interval->holds(value);
}

std::string faultOf(const std::string& condition, const std::string& unit) {
    std::string fault;
    const auto parsed = parseCondition(condition, fault);
    if (parsed) {
        EXPECT_FALSE(intervalOf(*parsed, unit, fault)) << condition;
    }
    return fault;
}

TEST(Condition, SignsCompareInTheUnitOfTheMetric) {
    EXPECT_TRUE(meets(39.9, "< 40 m", "m"));
    EXPECT_FALSE(meets(40, "< 40 m", "m"));
    EXPECT_TRUE(meets(40, "<= 4000 cm", "m"));
    EXPECT_FALSE(meets(40, "> 0.04 km", "m"));
    EXPECT_TRUE(meets(40, ">= 40", "m")) << "a number without unit is in that of the metric";
    EXPECT_TRUE(meets(0.34, "<= 35 %", "-"));
    EXPECT_FALSE(meets(0.36, "<=35%", "-"));
    EXPECT_TRUE(meets(57, "< 1 rad/s", "deg/s"));
    EXPECT_FALSE(meets(58, "< 1 rad/s", "deg/s"));
}

TEST(Condition, EqualIsEqualButForRounding) {
    EXPECT_TRUE(meets(0, "= 0", "-"));
    EXPECT_FALSE(meets(1, "= 0", "-"));
    EXPECT_TRUE(meets(0.1 + 0.2, "= 0.3", "-"));
}

TEST(Condition, RangesHoldTheirEnds) {
    EXPECT_TRUE(meets(30, "30 .. 40 m", "m"));
    EXPECT_TRUE(meets(40, "30 m .. 40 m", "m"));
    EXPECT_TRUE(meets(0.035, "30 .. 40 mm", "m")) << "the unit behind is that of both ends";
    EXPECT_FALSE(meets(41, "30..40", "m"));
}

TEST(Condition, ToleranceIsAShareOfTheValueOrInItsUnit) {
    EXPECT_TRUE(meets(38.9, "38.2 m +- 2 %", "m"));
    EXPECT_FALSE(meets(39.0, "38.2 m +- 2 %", "m"));
    EXPECT_TRUE(meets(-10.4, "-10 +- 5 %", "m/s2"));
    EXPECT_TRUE(meets(38.5, "38.2 m +- 30 cm", "m"));
    EXPECT_TRUE(meets(52, "50 % +- 3 %", "%")) << "of a metric in %, percentage points";
    EXPECT_FALSE(meets(54, "50 % +- 3 %", "%"));
}

TEST(Condition, WhatCouldNotBeComputedMeetsNothing) {
    EXPECT_FALSE(meets(std::nan(""), "< 40 m", "m"));
    EXPECT_FALSE(meets(std::nan(""), "> -1e9", "m"));
}

TEST(Condition, FaultsSayWhatWasFoundAndExpected) {
    for (const char* text : {"", "40 m", "< forty", "30 .. m", "<", "38 +- x"})
        EXPECT_NE(faultOf(text, "m").find("expected a condition such as \"< 40 m\""), std::string::npos) << text;
    EXPECT_NE(faultOf("< 40 furlong", "m").find("unknown unit \"furlong\""), std::string::npos);
    EXPECT_NE(faultOf("< 40 kg", "m").find("found a mass (\"kg\"), expected m"), std::string::npos);
    EXPECT_NE(faultOf("40 .. 30 m", "m").find("the smaller number first"), std::string::npos);
    EXPECT_NE(faultOf("40 m +- -1 m", "m").find("none below 0"), std::string::npos);
}

}  // namespace
}  // namespace tread::condition_test
