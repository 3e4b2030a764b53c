#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/envelope.h"

namespace tread::compare_envelope_test {
namespace {

Log crossPlot(const std::vector<double>& x, const std::vector<double>& y) {
    Log log{{{"time", "s", {}}, {"chassis.ay", "m/s2", x}, {"driver.steering_wheel_angle", "rad", y}}};
    for (std::size_t i = 0; i < x.size(); ++i) log.channels[0].values.push_back(static_cast<double>(i));
    return log;
}

// y = slope x for x from 0 to 5.
Log line(double slope) {
    std::vector<double> x, y;
    for (int i = 0; i <= 500; ++i) {
        x.push_back(i * 0.01);
        y.push_back(slope * i * 0.01);
    }
    return crossPlot(x, y);
}

EnvelopeJudgement judge(const Log& simulated, const Log& measured, const EnvelopeTolerance& tolerance) {
    return judgeEnvelope(simulated, measured, "chassis.ay", "driver.steering_wheel_angle", tolerance);
}

// The envelope of an ellipse with half axes a, b along y = m x is y = m x +- sqrt(b^2 + m^2 a^2).
TEST(Envelope, AroundALineTheBoundaryLiesAtTheClosedFormDistance) {
    const double slope = 0.4, a = 0.1, b = 0.08, distance = std::sqrt(b * b + slope * slope * a * a);
    const EnvelopeTolerance tolerance{a, 0, b, 0};
    const Log simulated = line(slope);
    for (const double x : {1.0, 2.5, 4.0}) {
        for (const double side : {1.0, -1.0}) {
            EXPECT_TRUE(judge(simulated, crossPlot({x}, {slope * x + side * distance * 0.9999}), tolerance).inside);
            EXPECT_FALSE(judge(simulated, crossPlot({x}, {slope * x + side * distance * 1.0001}), tolerance).inside);
        }
    }
    const auto drawn = judge(simulated, simulated, tolerance);
    EXPECT_TRUE(drawn.inside);
    EXPECT_EQ(drawn.worst, 0);
    ASSERT_FALSE(drawn.top.empty());
    for (std::size_t i = 0; i < drawn.top.size(); ++i) {
        EXPECT_NEAR(drawn.top[i].y - slope * drawn.top[i].x, distance, 1e-12);
        EXPECT_NEAR(drawn.bottom[i].y - slope * drawn.bottom[i].x, -distance, 1e-12);
    }
}

TEST(Envelope, TheGainWidensTheBoundaryWithTheValue) {
    const EnvelopeTolerance tolerance{0.1, 0, 0.01, 0.1};  // along a horizontal line only the y tolerance counts
    const Log simulated = crossPlot({0, 5}, {2, 2});
    EXPECT_TRUE(judge(simulated, crossPlot({2}, {2.2099}), tolerance).inside);
    EXPECT_FALSE(judge(simulated, crossPlot({2}, {2.2101}), tolerance).inside);
}

TEST(Envelope, PointsBeyondTheSimulatedRangeAreNotJudged) {
    const EnvelopeTolerance tolerance{0.1, 0, 0.1, 0};
    const auto result = judge(line(1), crossPlot({-3, 2, 7, std::nan("")}, {0, 2, 7, 1}), tolerance);
    EXPECT_TRUE(result.inside);
    EXPECT_EQ(result.judged, 1u);
    EXPECT_EQ(result.not_covered, 3u);
    EXPECT_FALSE(judge(line(1), crossPlot({7}, {7}), tolerance).inside) << "nothing judged is no pass";
}

TEST(Envelope, APointFarOffTheEndOfTheCurveButWithinItsRangeIsOutside) {
    const auto result = judge(line(1), crossPlot({2, 5}, {2, 50}), EnvelopeTolerance{0.1, 0, 0.1, 0});
    EXPECT_FALSE(result.inside);
    EXPECT_EQ(result.outside, 1u);
    EXPECT_EQ(result.first_outside_time, 1.0);
    EXPECT_NEAR(result.worst, 450, 1);
}

TEST(Envelope, ACurveThatTurnsBackIsFollowed) {
    std::vector<double> x, y;
    for (int i = 0; i <= 1000; ++i) {
        x.push_back(5 * std::sin(i * 0.00628));
        y.push_back(5 * std::cos(i * 0.00628));
    }
    const EnvelopeTolerance tolerance{0.2, 0, 0.2, 0};
    EXPECT_TRUE(judge(crossPlot(x, y), crossPlot({0, 0, 5.19}, {4.81, -5.19, 0}), tolerance).inside);
    EXPECT_FALSE(judge(crossPlot(x, y), crossPlot({0}, {4.79}), tolerance).inside);
    EXPECT_FALSE(judge(crossPlot(x, y), crossPlot({0}, {0}), tolerance).inside) << "the middle of a loop is outside";
}

TEST(Envelope, AMissingChannelIsNamed) {
    try {
        judgeEnvelope(line(1), line(1), "chassis.ay", "chassis.roll", {0.1, 0, 0.1, 0});
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "the simulated log has no channel chassis.roll");
    }
    EXPECT_THROW(judge(crossPlot({1, 1}, {2, 2}), line(1), {0.1, 0, 0.1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace tread::compare_envelope_test
