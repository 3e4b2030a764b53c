#include "compare/cross_plots.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

namespace tread::compare_cross_plots_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Understeer: the steering wheel over lateral acceleration, with an error in the steering wheel and noise-free.
Log circle(double wheel_offset, double roll_gain = 0.01) {
    Log log{{{"time", "s", {}},
             {"chassis.ay", "m/s2", {}},
             {"driver.steering_wheel_angle", "rad", {}},
             {"chassis.roll", "rad", {}}}};
    for (int i = 0; i <= 600; ++i) {
        const double ay = 0.01 * i;
        const double row[] = {0.1 * i, ay, 0.5 + 0.05 * ay + wheel_offset, roll_gain * ay};
        for (std::size_t c = 0; c < 4; ++c) log.channels[c].values.push_back(row[c]);
    }
    return log;
}

TEST(CrossPlots, MeasurementsInsideTheBoundariesPass) {
    const std::vector<NamedLog> measured{
        {"a.csv", circle(4 * kDegree)}, {"b.csv", circle(0)}, {"c.csv", circle(-4 * kDegree)}};
    const CrossPlotResult result = judgeCrossPlots(circle(0), measured, {});
    EXPECT_TRUE(result.inside) << text(result);
    EXPECT_EQ(result.plots.size(), 6u) << "steering wheel and roll; no log has a sideslip";
    ASSERT_EQ(result.notes.size(), 3u);
    EXPECT_EQ(result.notes[0],
              "chassis.sideslip over chassis.ay of a.csv was not judged: the simulated log has no channel "
              "chassis.sideslip.");
    EXPECT_EQ(text(result).find("Inside: the measurements lie within the boundaries of 6 cross-plots"), 0u);
}

TEST(CrossPlots, OneMeasurementOutsideFails) {
    const std::vector<NamedLog> measured{{"a.csv", circle(0)}, {"b.csv", circle(8 * kDegree)}};
    const CrossPlotResult result = judgeCrossPlots(circle(0), measured, {});
    EXPECT_FALSE(result.inside);
    EXPECT_EQ(text(result).find("Outside: "), 0u);
    EXPECT_NE(text(result).find("driver.steering_wheel_angle over chassis.ay lie outside the boundaries"),
              std::string::npos);
    EXPECT_EQ(result.notes[0], "ISO 19364 requires at least 3 measurements of the manoeuvre; 2 are given.");
    EXPECT_EQ(json(result)["inside"], false);
    EXPECT_EQ(json(result)["plots"][1]["measurement"], "b.csv");
}

// Without slope the boundary lies at offset + gain |y|: 5 deg + 3 % of 0.5 rad.
TEST(CrossPlots, TheDefaultsAreThoseOfTheSource) {
    const auto judged = [](double wheel) {
        const auto level = [](double value) {
            Log log = circle(0);
            for (double& angle : log.channels[2].values) angle = value;
            return log;
        };
        return judgeCrossPlots(level(0.5), {{"a.csv", level(wheel)}}, {}).inside;
    };
    const double boundary = 5 * kDegree + 0.03 * 0.5;
    EXPECT_TRUE(judged(0.5 + 0.999 * boundary));
    EXPECT_FALSE(judged(0.5 + 1.001 * boundary));
}

TEST(CrossPlots, NothingToJudgeIsNoPass) {
    const Log bare{{{"time", "s", {0, 1}}}};
    const CrossPlotResult result = judgeCrossPlots(bare, {{"a.csv", circle(0)}}, {});
    EXPECT_FALSE(result.inside);
    EXPECT_EQ(text(result).find("Not judged: "), 0u);
}

}  // namespace
}  // namespace tread::compare_cross_plots_test
