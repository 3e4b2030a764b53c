// Parked cars, and cars dropped onto their wheels.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "metrics_sample.h"

namespace tread::metrics_standing_test {
namespace {

using namespace sample;

Log parkedLog(double rate, double creep_x, double creep_y, double turn) {
    return log(rate, 21,
               {{"chassis.x", "m", [=](double t) { return 5 + creep_x * t - 0.05 * std::exp(-20 * t); }},
                {"chassis.y", "m", [=](double t) { return creep_y * t; }},
                {"chassis.yaw", "rad", [=](double t) { return 1 + turn * t; }},
                {"chassis.vx", "m/s", [=](double t) { return creep_x + std::exp(-20 * t); }},
                {"chassis.vy", "m/s", constant(creep_y)}});
}

TEST(Parked, DriftSpeedAndRotationAreThoseOfTheCreep) {
    for (const double rate : kRates) {
        const auto found = metrics(parkedLog(rate, 3e-5, -4e-5, 2e-6), "parked");
        EXPECT_NEAR(valueOf(found, "drift"), 5e-5 * 60 * 1000, 1e-4)
            << "3 mm a minute; the first second does not count";
        EXPECT_NEAR(valueOf(found, "largest_excursion"), 5e-5 * 20 * 1000, 1e-4);
        EXPECT_NEAR(valueOf(found, "largest_speed"), 5e-5, 1e-8);
        EXPECT_NEAR(valueOf(found, "rotation"), 2e-6 * 60 / kDegree, 1e-6);
    }
}

TEST(Parked, ACarThatStandsHasNoDriftAtAll) {
    const auto found = metrics(parkedLog(100, 0, 0, 0), "parked");
    EXPECT_LT(valueOf(found, "drift"), 1e-6);
    EXPECT_LT(valueOf(found, "largest_excursion"), 1e-6);
}

TEST(Parked, NoiseOfASensorIsNoDrift) {
    Log log = parkedLog(100, 0, 0, 0);
    addNoise(log, "chassis.x", 0.002, 1);
    EXPECT_LT(valueOf(metrics(log, "parked"), "drift"), 3);
}

TEST(Parked, ACarThatMovesOrAShortLogIsRefused) {
    EXPECT_NE(errorOf(parkedLog(100, 1, 0, 0), "parked").find("the car moves at up to 1 m/s"), std::string::npos);
    Log log = parkedLog(100, 0, 0, 0);
    for (Channel& channel : log.channels) channel.values.resize(120);
    EXPECT_NE(errorOf(log, "parked").find("the log lasts 1.2 s"), std::string::npos);
}

constexpr double kNatural = 1.4, kDamping = 0.25, kDrop = 0.08;  // Hz, -, m
constexpr double kRest = 0.55;

// A body that is let go above its rest: z = rest + drop exp(-d w t) (cos(wd t) + d w / wd sin(wd t)).
double bounceAt(double t) {
    const double w = 2 * std::numbers::pi * kNatural, wd = w * std::sqrt(1 - kDamping * kDamping);
    return kRest + kDrop * std::exp(-kDamping * w * t) * (std::cos(wd * t) + kDamping * w / wd * std::sin(wd * t));
}

Log dropLog(double rate) {
    return log(rate, 6, {{"chassis.z", "m", bounceAt}, {"chassis.vx", "m/s", constant(0)}});
}

TEST(DropAndSettle, FrequencyDampingAndOvershootAreThoseOfTheOscillator) {
    const double overshoot = std::exp(-std::numbers::pi * kDamping / std::sqrt(1 - kDamping * kDamping));
    for (const double rate : kRates) {
        const auto found = metrics(dropLog(rate), "drop_and_settle");
        // Turning points come from parabolas through three samples, off by (w h)^2 / 20 of the swing at most.
        const double relative = std::pow(2 * std::numbers::pi * kNatural / rate, 2) / 20 + 1e-5;
        EXPECT_NEAR(valueOf(found, "bounce_frequency") / kNatural, 1, relative) << rate;
        EXPECT_NEAR(valueOf(found, "damping_ratio") / kDamping, 1, relative) << rate;
        EXPECT_NEAR(valueOf(found, "damped_frequency") / (kNatural * std::sqrt(1 - kDamping * kDamping)), 1, relative);
        EXPECT_NEAR(valueOf(found, "overshoot"), overshoot, 1e-3);
        EXPECT_NEAR(valueOf(found, "drop"), 1000 * kDrop, 0.01);
        double settled = 6;
        while (std::abs(bounceAt(settled) - kRest) <= 0.02 * kDrop) settled -= 1e-5;
        EXPECT_NEAR(valueOf(found, "settling_time"), settled, 0.3 / rate) << rate;
    }
}

TEST(DropAndSettle, HeavyDampingSettlesWithoutSwinging) {
    const Log creeping = log(100, 6,
                             {{"chassis.z", "m", [](double t) { return 0.5 + 0.05 * std::exp(-3 * t); }},
                              {"chassis.vx", "m/s", constant(0)}});
    const auto found = metrics(creeping, "drop_and_settle");
    EXPECT_NEAR(valueOf(found, "overshoot"), 0, 1e-6);
    EXPECT_TRUE(std::isnan(valueOf(found, "damping_ratio")));
    EXPECT_TRUE(std::isnan(valueOf(found, "bounce_frequency")));
    EXPECT_NEAR(valueOf(found, "settling_time"), std::log(50) / 3, 1e-3);
}

TEST(DropAndSettle, MeasurementNoiseMovesTheMetricsLittle) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Log log = dropLog(100);
        addNoise(log, "chassis.z", 0.0002, seed);
        const auto found = metrics(log, "drop_and_settle");
        EXPECT_NEAR(valueOf(found, "bounce_frequency") / kNatural, 1, 0.03) << seed;
        EXPECT_NEAR(valueOf(found, "damping_ratio"), kDamping, 0.03) << seed;
    }
}

TEST(DropAndSettle, WhatIsNoDropIsRefusedWithTheReason) {
    Log still = dropLog(100);
    for (double& z : channel(still, "chassis.z").values) z = kRest;
    EXPECT_NE(errorOf(still, "drop_and_settle").find("sinks by"), std::string::npos);
    Log driving = dropLog(100);
    for (double& v : channel(driving, "chassis.vx").values) v = 10;
    EXPECT_NE(errorOf(driving, "drop_and_settle").find("the car moves at 10 m/s"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_standing_test
