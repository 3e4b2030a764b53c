// Acceleration, and starting on a hill.

#include <gtest/gtest.h>

#include <cmath>

#include "unit/metrics_sample.h"

namespace tread::metrics_driving_off_test {
namespace {

using sample::errorOf;
using sample::kRates;
using sample::valueOf;

constexpr double kOnset = 1.5, kPull = 3;  // s, m/s2

Log fullThrottle(double rate, double initial = 0) {
    const auto since = [](double t) { return std::max(0.0, t - kOnset); };
    return sample::log(rate, 25,
                       {{"driver.throttle", "-", [=](double t) { return std::min(1.0, 10 * since(t)); }},
                        {"driver.brake", "-", sample::constant(0)},
                        {"chassis.vx", "m/s", [=](double t) { return initial + kPull * since(t); }}});
}

TEST(Acceleration, TimesAndDistancesAreThoseOfConstantAcceleration) {
    for (const double rate : kRates) {
        const auto found = metrics(fullThrottle(rate), "acceleration");
        const double late = 0.002 + 0.5 / rate;  // the pedal has to pass 2 %
        EXPECT_NEAR(valueOf(found, "time_0_to_100_kmh"), 100 / 3.6 / kPull, late) << rate;
        EXPECT_NEAR(valueOf(found, "time_0_to_60_kmh"), 60 / 3.6 / kPull, late) << rate;
        EXPECT_NEAR(valueOf(found, "time_80_to_120_kmh"), 40 / 3.6 / kPull, 1e-6) << rate;
        EXPECT_NEAR(valueOf(found, "distance_0_to_100_kmh"), std::pow(100 / 3.6, 2) / 2 / kPull, 0.1) << rate;
        EXPECT_NEAR(valueOf(found, "time_400_m"), std::sqrt(2 * 400 / kPull), late) << rate;
        EXPECT_NEAR(valueOf(found, "peak_acceleration"), kPull, 1e-6) << rate;
        EXPECT_NEAR(valueOf(found, "largest_speed"), kPull * 23.5, 1e-6) << rate;
    }
}

TEST(Acceleration, ARollingStartHasNoTimesFromRest) {
    const auto found = metrics(fullThrottle(100, 15), "acceleration");
    EXPECT_TRUE(std::isnan(valueOf(found, "time_0_to_100_kmh")));
    EXPECT_NEAR(valueOf(found, "time_80_to_120_kmh"), 40 / 3.6 / kPull, 1e-6);
    EXPECT_NEAR(valueOf(found, "initial_speed"), 15, 0.1);
}

TEST(Acceleration, HalfThrottleAndACarThatStaysAreRefused) {
    Log log = fullThrottle(100);
    for (double& value : sample::channel(log, "driver.throttle").values) value *= 0.5;
    EXPECT_NE(errorOf(log, "acceleration").find("never opened fully"), std::string::npos);
    log = fullThrottle(100);
    for (double& value : sample::channel(log, "chassis.vx").values) value = 0;
    EXPECT_NE(errorOf(log, "acceleration").find("gains only 0 m/s"), std::string::npos);
}

// Released at 2 s, the car rolls back at 1.2 m/s2 for half a second, then is driven forwards at 2 m/s2: back by
// 0.15 m while it rolls and by 0.09 m until it stands.
Log hill(double rate) {
    const auto v = [](double t) {
        if (t < 2) return 0.0;
        return t < 2.5 ? -1.2 * (t - 2) : -0.6 + 2 * (t - 2.5);
    };
    return sample::log(rate, 8,
                       {{"driver.brake", "-", [](double t) { return t < 2 ? 0.4 : 0; }},
                        {"driver.throttle", "-", [](double t) { return t < 2.4 ? 0 : 0.5; }},
                        {"chassis.pitch", "rad", sample::constant(-0.1)},
                        {"chassis.vx", "m/s", v}});
}

TEST(HillStart, RollsBackUntilTheEngineHolds) {
    for (const double rate : kRates) {
        const auto found = metrics(hill(rate), "hill_start");
        EXPECT_NEAR(valueOf(found, "roll_back"), 0.15 + 0.09, 0.002) << rate;
        EXPECT_NEAR(valueOf(found, "roll_back_speed"), 0.6, 1e-6) << rate;
        EXPECT_NEAR(valueOf(found, "drive_off_time"), 0.5 + 2.6 / 2, 1 / rate) << rate;
        EXPECT_NEAR(valueOf(found, "held_drift"), 0, 1e-9);
    }
}

TEST(HillStart, FlatGroundOrNoThrottleIsRefused) {
    Log log = hill(100);
    for (double& value : sample::channel(log, "chassis.pitch").values) value = 0;
    EXPECT_NE(errorOf(log, "hill_start").find("does not stand on a hill"), std::string::npos);
    log = hill(100);
    for (double& value : sample::channel(log, "driver.throttle").values) value = 0;
    EXPECT_NE(errorOf(log, "hill_start").find("throttle is not used"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_driving_off_test
