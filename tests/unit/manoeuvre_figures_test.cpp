#include "report/manoeuvre_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/metrics.h"
#include "shared/vehicles.h"

namespace tread::manoeuvre_figures_test {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

Log logOver(std::size_t samples, double dt) {
    Log log{{{"time", "s", {}}}};
    for (std::size_t i = 0; i < samples; ++i) log.channels.front().values.push_back(static_cast<double>(i) * dt);
    return log;
}

void add(Log& log, const std::string& name, const std::string& unit, auto value) {
    Channel channel{name, unit, {}};
    for (const double t : log.channels.front().values) channel.values.push_back(value(t));
    log.channels.push_back(std::move(channel));
}

std::vector<Chart> figuresOf(const Log& log, RunRecord record, std::vector<Metric> metrics = {}) {
    record.vehicle = reference::compact();
    return manoeuvreFigures({.title = "",
                             .answer = "",
                             .vehicle = "",
                             .scenario = "",
                             .version = "",
                             .log = log,
                             .metrics = std::move(metrics),
                             .record = &record});
}

RunRecord recordOf(const std::string& manoeuvre) {
    RunRecord record;
    record.scenario.manoeuvre = manoeuvre;
    return record;
}

const Chart* named(const std::vector<Chart>& charts, const std::string& title) {
    const auto found = std::find_if(charts.begin(), charts.end(), [&](const Chart& c) { return c.title == title; });
    return found == charts.end() ? nullptr : &*found;
}

TEST(ManoeuvreFigures, EveryKindDrawsNothingOfALogThatHoldsNothing) {
    const Log log = logOver(10, 0.1);
    for (const Manoeuvre& manoeuvre : manoeuvres())
        EXPECT_TRUE(figuresOf(log, recordOf(std::string(manoeuvre.name))).empty()) << manoeuvre.name;
}

// Steering wheel: 2 deg and 30 deg/g, to the right.
TEST(ManoeuvreFigures, TheUndersteerGradientLiesOnTheCurveThatItDescribes) {
    Log log = logOver(500, 0.01);
    add(log, "chassis.ay", "m/s2", [](double t) { return -t; });
    add(log, "driver.steering_wheel_angle", "rad", [](double t) { return -(2 + 30 * t / 9.80665) / kDegrees; });
    const auto charts =
        figuresOf(log, recordOf("slowly_increasing_steer"), {{"steering_wheel_gradient", 30, "deg/g", ""}});
    const Chart* chart = named(charts, "Understeer");
    ASSERT_NE(chart, nullptr);
    ASSERT_EQ(chart->series.size(), 2u);
    const Series &curve = chart->series[0], &line = chart->series[1];
    EXPECT_GT(curve.x.back(), 4.9) << "a right turn is drawn as a left one";
    EXPECT_NEAR(line.y.front(), 2, 1e-9);
    EXPECT_NEAR(line.y.back(), curve.y.back(), 1e-9);
}

TEST(ManoeuvreFigures, BrakingIsDrawnOverTheDistanceFromThePedalOn) {
    Log log = logOver(301, 0.01);
    add(log, "driver.brake", "-", [](double t) { return t < 1 ? 0.0 : 1.0; });
    add(log, "chassis.vx", "m/s", [](double t) { return t < 1 ? 20.0 : 20 - 8 * (t - 1); });
    add(log, "chassis.ax", "m/s2", [](double t) { return t < 1 ? 0.0 : -8.0; });
    const auto charts = figuresOf(log, recordOf("straight_braking"), {{"mfdd", 8, "m/s2", ""}});
    const Chart* chart = named(charts, "Deceleration");
    ASSERT_NE(chart, nullptr);
    const Series& curve = chart->series.front();
    EXPECT_TRUE(std::isnan(curve.x[99])) << "before the pedal nothing is drawn";
    EXPECT_EQ(curve.x[100], 0);
    EXPECT_NEAR(curve.x.back(), 20 * 2 - 0.5 * 8 * 4, 1e-9);
    EXPECT_EQ(curve.y.back(), 8);
    ASSERT_EQ(chart->series.size(), 2u);
    EXPECT_EQ(chart->series[1].y.front(), 8) << "the mean fully developed deceleration";
}

// From 20 m/s to rest, with a jerk at the end: chart and metric leave it out.
TEST(ManoeuvreFigures, TheDecelerationThatIsDrawnHasThePeakThatTheMetricHas) {
    Log log = logOver(501, 0.01);
    const auto speed = [](double t) { return t < 1 ? 20.0 : std::max(0.0, 20 - 8 * (t - 1)); };
    add(log, "driver.brake", "-", [](double t) { return t < 1 ? 0.0 : 1.0; });
    add(log, "chassis.vx", "m/s", speed);
    add(log, "chassis.ax", "m/s2", [&](double t) {
        return t < 1 || speed(t) == 0 ? 0.0 : speed(t) < 1.9 ? -30.0 : t < 1.2 ? -9.0 : -8.0;
    });
    const auto found = metrics(log, "straight_braking");
    const auto peak =
        std::find_if(found.begin(), found.end(), [](const auto& m) { return m.name == "peak_deceleration"; });
    ASSERT_NE(peak, found.end());
    const auto charts = figuresOf(log, recordOf("straight_braking"), found);
    const Chart* chart = named(charts, "Deceleration");
    ASSERT_NE(chart, nullptr);
    double largest = 0;
    for (std::size_t i = 0; i < chart->series[0].x.size(); ++i)
        if (std::isfinite(chart->series[0].x[i])) largest = std::max(largest, chart->series[0].y[i]);
    EXPECT_NEAR(largest, peak->value, 1e-9);
    EXPECT_NEAR(largest, 9, 1e-9);
    EXPECT_EQ(chart->series[1].name, "peak, 9.00 m/s²");
}

// Vertical acceleration of 3 Hz and 0.5 m/s2, wheel loads of 10 Hz and 400 N.
TEST(ManoeuvreFigures, ARideHasTheSpectraOfAccelerationAndWheelLoads) {
    Log log = logOver(2001, 0.01);
    const auto sine = [](double size, double frequency) {
        return [=](double t) { return size * std::sin(2 * std::numbers::pi * frequency * t); };
    };
    add(log, "chassis.az", "m/s2", sine(0.5, 3));
    add(log, "wheel.front_left.load", "N", sine(400, 10));
    const auto charts = figuresOf(log, recordOf("ride"));
    ASSERT_NE(named(charts, "Vertical acceleration"), nullptr);
    const Chart *body = named(charts, "Spectrum of the vertical acceleration"),
                *loads = named(charts, "Spectra of the wheel loads");
    ASSERT_NE(body, nullptr);
    ASSERT_NE(loads, nullptr);
    const auto area = [](const Series& series) {
        double sum = 0;
        for (std::size_t i = 1; i < series.x.size(); ++i)
            sum += 0.5 * (series.y[i] + series.y[i - 1]) * (series.x[i] - series.x[i - 1]);
        return sum;
    };
    const auto peakAt = [](const Series& series) {
        return series
            .x[static_cast<std::size_t>(std::max_element(series.y.begin(), series.y.end()) - series.y.begin())];
    };
    EXPECT_NEAR(area(body->series[0]), 0.5 * 0.25, 0.002) << "the variance";
    EXPECT_NEAR(peakAt(body->series[0]), 3, 0.06);
    EXPECT_LT(area(body->series[1]), area(body->series[0])) << "3 Hz is felt less";
    EXPECT_NEAR(area(loads->series[0]), 0.5 * 0.16, 0.002) << "in kN2";
    EXPECT_NEAR(peakAt(loads->series[0]), 10, 0.06);
}

// A car that answers the steering wheel with a lag of first order, 0.2 s, and gain 0.3.
TEST(ManoeuvreFigures, BodePlotsShowTheGainAndThePhaseOfALag) {
    Log log = logOver(6001, 0.01);
    const auto chirp = [](double t) {
        return t < 1 || t > 51 ? 0 : 0.2 * std::sin(std::numbers::pi * 0.06 * (t - 1) * (t - 1));
    };
    add(log, "driver.steering_wheel_angle", "rad", chirp);
    add(log, "chassis.vx", "m/s", [](double) { return 25.0; });
    double state = 0;
    add(log, "chassis.yaw_rate", "rad/s", [&](double t) {
        for (int i = 0; i < 10; ++i) state += 0.001 / 0.2 * (0.3 * chirp(t + 0.001 * i - 0.01) - state);
        return state;
    });
    add(log, "chassis.ay", "m/s2", [](double t) { return 10 * std::sin(t); });
    const auto charts = figuresOf(log, recordOf("frequency_response"));
    const Chart *gain = named(charts, "Gain of the yaw rate"), *phase = named(charts, "Phase");
    ASSERT_NE(gain, nullptr);
    ASSERT_NE(phase, nullptr);
    const Series &g = gain->series.front(), &p = phase->series.front();
    for (std::size_t i = 0; i < g.x.size(); ++i) {
        if (g.x[i] < 0.5 || g.x[i] > 2) continue;
        const double turn = 2 * std::numbers::pi * g.x[i] * 0.2;
        EXPECT_NEAR(g.y[i], 0.3 / std::hypot(1, turn), 0.01) << g.x[i];
        EXPECT_NEAR(p.y[i], -kDegrees * std::atan(turn), 4) << g.x[i];
    }
}

TEST(ManoeuvreFigures, TheCourseHasItsConesAndTheOutlineOfTheCar) {
    Log log = logOver(501, 0.01);
    add(log, "chassis.x", "m", [](double t) { return 10 * t; });
    add(log, "chassis.y", "m", [](double) { return 0.0; });
    add(log, "chassis.yaw", "rad", [](double) { return 0.0; });
    RunRecord record = recordOf("lane_change");
    record.scenario.course = {
        .begin = 20, .car = {.width = 1.8, .ahead = 2, .behind = 2.2}, .sections = {}, .path = {}};
    record.scenario.course.sections.push_back({.from = 0, .to = 10, .width_extra = 0.25, .cones = 3});
    const auto charts = figuresOf(log, record);
    const Chart* chart = named(charts, "Course from above");
    ASSERT_NE(chart, nullptr);
    const Series& cones = chart->series.back();
    ASSERT_EQ(cones.x.size(), 6u);
    EXPECT_DOUBLE_EQ(cones.x[2], 25);
    EXPECT_NEAR(std::abs(cones.y[2]), 0.5 * (1.8 + 0.25), 1e-12);
    const auto car =
        std::find_if(chart->series.begin(), chart->series.end(), [](const Series& s) { return s.name == "car"; });
    ASSERT_NE(car, chart->series.end());
    const auto [rear, front] = std::minmax_element(car->x.begin(), car->x.end());
    EXPECT_NEAR(*front - *rear, 4.2, 1e-9);
}

}  // namespace
}  // namespace tread::manoeuvre_figures_test
