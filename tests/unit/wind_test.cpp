#include "scenario/wind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tread::wind_test {
namespace {

constexpr double kRounding = 1e-12;

TEST(Wind, BlowsTowardsItsDirection) {
    EXPECT_NEAR((windAt({.speed = 10, .direction = 0, .gust = {}}, 3, 50) - Vector3(10, 0, 0)).norm(), 0, kRounding);
    const Vector3 left = windAt({.speed = 8, .direction = std::numbers::pi / 2, .gust = {}}, 0, 0);
    EXPECT_NEAR((left - Vector3(0, 8, 0)).norm(), 0, kRounding);
    EXPECT_EQ(windAt({}, 5, 5), Vector3::Zero());
}

TEST(Wind, ComponentsAddToTheDirection) {
    EXPECT_NEAR((windAt({.speed = 3, .direction = 0, .x = 2, .y = -4, .gust = {}}, 1, 1) - Vector3(5, -4, 0)).norm(), 0,
                kRounding);
}

double gustAt(const GustParams& gust, double time, double x) {
    return windAt({.speed = 5, .direction = 0, .gust = gust}, time, x).x() - 5;
}

TEST(Wind, StepComesAtItsTimeAndStays) {
    const GustParams gust{.shape = GustShape::step, .speed = 20, .time = 2};
    EXPECT_EQ(gustAt(gust, 1.999, 0), 0);
    EXPECT_EQ(gustAt(gust, 2, 0), 20);
    EXPECT_EQ(gustAt(gust, 100, 0), 20);
}

TEST(Wind, RampRisesAndStays) {
    const GustParams gust{.shape = GustShape::ramp, .speed = 20, .time = 2, .duration = 4};
    EXPECT_EQ(gustAt(gust, 2, 0), 0);
    EXPECT_NEAR(gustAt(gust, 3, 0), 5, kRounding);
    EXPECT_EQ(gustAt(gust, 7, 0), 20);
}

TEST(Wind, CosineRisesAndFallsOverTheWay) {
    const GustParams gust{.shape = GustShape::cosine, .speed = 12, .x = 100, .length = 40};
    EXPECT_EQ(gustAt(gust, 50, 99), 0);
    EXPECT_NEAR(gustAt(gust, 0, 110), 6, kRounding);
    EXPECT_NEAR(gustAt(gust, 0, 120), 12, kRounding);
    EXPECT_NEAR(gustAt(gust, 0, 130), 6, kRounding);
    EXPECT_NEAR(gustAt(gust, 0, 141), 0, kRounding);
}

// What is wrong with a gust, or "".
std::string fault(const GustParams& gust) {
    std::string found;
    GustParams::check(gust, [&](std::string_view field, const std::string&) { found += std::string(field) + " "; });
    return found;
}

TEST(Wind, GustThatDoesNotSayWhenOrHowLongIsAnError) {
    EXPECT_EQ(fault({}), "");
    EXPECT_EQ(fault({.shape = GustShape::step, .speed = 5, .time = 1}), "");
    EXPECT_EQ(fault({.shape = GustShape::step, .speed = 5}), "time ");
    EXPECT_EQ(fault({.shape = GustShape::step, .speed = 5, .time = 1, .x = 3}), "time ");
    EXPECT_EQ(fault({.shape = GustShape::ramp, .speed = 5, .time = 1, .length = 3}), "duration ");
    EXPECT_EQ(fault({.shape = GustShape::cosine, .speed = 5, .duration = 3, .x = 1}), "length ");
}

}  // namespace
}  // namespace tread::wind_test
