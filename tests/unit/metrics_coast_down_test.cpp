#include <gtest/gtest.h>

#include <cmath>

#include "metrics_sample.h"

namespace tread::metrics_coast_down_test {
namespace {

using namespace sample;

Log coastLog(double rate, double duration, const std::function<double(double)>& v) {
    return log(rate, duration,
               {{"driver.throttle", "-", constant(0)},
                {"driver.brake", "-", constant(0)},
                {"driver.steering_wheel_angle", "rad", constant(0)},
                {"chassis.vx", "m/s", v}});
}

// Drag only: v = v0 / (1 + v0 k t), distance ln(1 + v0 k t) / k.
TEST(CoastDown, DragAloneIsFoundFromItsClosedForm) {
    const double v0 = 35, k = 3.5e-4;
    for (const double rate : kRates) {
        const auto found = metrics(coastLog(rate, 60, [=](double t) { return v0 / (1 + v0 * k * t); }), "coast_down");
        EXPECT_NEAR(valueOf(found, "deceleration_square"), k, 1e-6 * k) << rate;
        EXPECT_NEAR(valueOf(found, "deceleration_constant"), 0, 1e-6);
        EXPECT_NEAR(valueOf(found, "drag_area_over_mass"), 2 * k / 1.225, 1e-8);
        EXPECT_NEAR(valueOf(found, "distance"), std::log(1 + v0 * k * 60) / k, 1e-3);
        const double v1 = 120 / 3.6, v2 = 100 / 3.6;
        EXPECT_NEAR(valueOf(found, "time_120_to_100_kmh"), (1 / v2 - 1 / v1) / k, 1e-4);
        EXPECT_NEAR(valueOf(found, "distance_120_to_100_kmh"), std::log(v1 / v2) / k, 1e-3);
    }
}

// Rolling resistance and drag: v = sqrt(a0 / a2) tan(c - sqrt(a0 a2) t).
double bothAt(double t) {
    const double a0 = 0.12, a2 = 3e-4, v0 = 33;
    return std::sqrt(a0 / a2) * std::tan(std::atan(v0 * std::sqrt(a2 / a0)) - std::sqrt(a0 * a2) * t);
}

TEST(CoastDown, RollingResistanceAndDragAreToldApart) {
    for (const double rate : kRates) {
        const auto found = metrics(coastLog(rate, 60, bothAt), "coast_down");
        EXPECT_NEAR(valueOf(found, "deceleration_constant"), 0.12, 1e-6);
        EXPECT_NEAR(valueOf(found, "deceleration_square"), 3e-4, 1e-8);
        EXPECT_NEAR(valueOf(found, "rolling_resistance"), 0.12 / kGravity, 1e-7);
        EXPECT_LT(valueOf(found, "fit_rms"), 1e-6);
    }
}

TEST(CoastDown, MeasurementNoiseMovesTheMetricsLittle) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Log log = coastLog(100, 60, bothAt);
        addNoise(log, "chassis.vx", 0.03, seed);
        const auto found = metrics(log, "coast_down");
        EXPECT_NEAR(valueOf(found, "deceleration_constant"), 0.12, 0.003) << seed;
        EXPECT_NEAR(valueOf(found, "deceleration_square"), 3e-4, 6e-6) << seed;
        EXPECT_NEAR(valueOf(found, "fit_rms"), 0.03, 0.002) << seed;
    }
}

TEST(CoastDown, OnlyTheTimeWithReleasedPedalsIsUsed) {
    Log log = coastLog(100, 60, bothAt);
    const std::vector<double>& time = log.channels[0].values;
    for (std::size_t i = 0; i < log.samples(); ++i) {
        if (time[i] < 10) channel(log, "driver.throttle").values[i] = 0.5, channel(log, "chassis.vx").values[i] = 40;
        if (time[i] > 50) channel(log, "driver.brake").values[i] = 0.5, channel(log, "chassis.vx").values[i] *= 0.5;
    }
    const auto found = metrics(log, "coast_down");
    EXPECT_NEAR(valueOf(found, "time"), 40, 0.011);
    EXPECT_NEAR(valueOf(found, "deceleration_constant"), 0.12, 1e-6);
}

TEST(CoastDown, WhatIsNoCoastDownIsRefusedWithTheReason) {
    EXPECT_NE(errorOf(coastLog(100, 60, constant(30)), "coast_down").find("goes from 30 to 30 m/s"), std::string::npos);
    EXPECT_NE(errorOf(coastLog(100, 2, bothAt), "coast_down").find("for only 2 s"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_coast_down_test
