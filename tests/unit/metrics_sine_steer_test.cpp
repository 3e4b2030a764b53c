#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "metrics_sample.h"

namespace tread::metrics_sine_steer_test {
namespace {

using namespace sample;

constexpr double kAmplitude = 0.4, kSpeed = 22;

std::complex<double> secondOrder(double omega) {
    const double natural = 7, damping = 0.6;
    return 0.3 * natural * natural /
           std::complex<double>(natural * natural - omega * omega, 2 * damping * natural * omega);
}
std::complex<double> firstOrder(double omega) {
    return 9.0 / std::complex<double>(1, 0.25 * omega);
}

// A sine from t = 1 s on; the answers as in the steady state, with a quickly dying transient at the beginning.
Log continuousLog(double rate, double frequency, double periods) {
    const double omega = 2 * std::numbers::pi * frequency, end = 1 + periods / frequency;
    const auto answer = [=](const std::complex<double>& h) {
        return [=](double t) {
            if (t < 1) return 0.0;
            const double steady = std::imag(h * std::polar(kAmplitude, omega * (t - 1)));
            return steady - std::imag(h) * kAmplitude * std::exp(-8 * (t - 1));
        };
    };
    return log(rate, end,
               {{"driver.steering_wheel_angle", "rad",
                 [=](double t) { return t < 1 ? 0.0 : kAmplitude * std::sin(omega * (t - 1)); }},
                {"chassis.vx", "m/s", constant(kSpeed)},
                {"chassis.yaw_rate", "rad/s", answer(secondOrder(omega))},
                {"chassis.ay", "m/s2", answer(firstOrder(omega))}});
}

// One period from t = 1 s on; the answers are copies that are late.
constexpr double kYawLag = 0.0834, kAyLag = 0.1657;
Log onePeriodLog(double rate, double frequency, double sign = 1) {
    const auto sine = [=](double t) {
        return t < 1 || t > 1 + 1 / frequency ? 0.0 : sign * std::sin(2 * std::numbers::pi * frequency * (t - 1));
    };
    return log(rate, 2.5 + 1 / frequency,
               {{"driver.steering_wheel_angle", "rad", [=](double t) { return kAmplitude * sine(t); }},
                {"chassis.vx", "m/s", constant(kSpeed)},
                {"chassis.yaw_rate", "rad/s", [=](double t) { return kAmplitude * 0.3 * sine(t - kYawLag); }},
                {"chassis.ay", "m/s2", [=](double t) { return kAmplitude * 9 * sine(t - kAyLag); }}});
}

double lagOf(const std::complex<double>& h) {
    return -std::arg(h) / kDegree;
}

TEST(SineSteer, GainAndPhaseOfAContinuousSineAreThoseOfTheTransferFunction) {
    for (const double rate : kRates) {
        for (const double frequency : {0.2, 0.5, 1.0, 1.7}) {
            const double omega = 2 * std::numbers::pi * frequency;
            const auto found = metrics(continuousLog(rate, frequency, 5), "sine_steer");
            EXPECT_EQ(valueOf(found, "periods"), 2);
            EXPECT_NEAR(valueOf(found, "frequency"), frequency, 1e-5 * frequency) << rate;
            EXPECT_NEAR(valueOf(found, "steering_amplitude"), kAmplitude / kDegree, 1e-3);
            EXPECT_NEAR(valueOf(found, "yaw_rate_gain"), std::abs(secondOrder(omega)), 1e-4) << frequency;
            EXPECT_NEAR(valueOf(found, "yaw_rate_phase_lag"), lagOf(secondOrder(omega)), 0.02) << frequency;
            EXPECT_NEAR(valueOf(found, "ay_gain"), std::abs(firstOrder(omega)), 3e-3) << frequency;
            EXPECT_NEAR(valueOf(found, "ay_phase_lag"), lagOf(firstOrder(omega)), 0.02) << frequency;
        }
    }
}

TEST(SineSteer, LagsOfASinglePeriodAreThoseOfTheDelayedCopies) {
    for (const double rate : kRates) {
        for (const double sign : {1.0, -1.0}) {
            const auto found = metrics(onePeriodLog(rate, 0.5, sign), "sine_steer");
            EXPECT_EQ(valueOf(found, "periods"), 1);
            EXPECT_NEAR(valueOf(found, "frequency"), 0.5, 1e-3);
            // A parabola through three samples of a sine misses its peak by less than (omega h)^2 / 10 of a sample.
            const double tolerance = std::pow(std::numbers::pi / rate, 2) / rate / 10 + 1e-7;
            EXPECT_NEAR(valueOf(found, "yaw_rate_first_peak_lag"), kYawLag, tolerance) << rate;
            EXPECT_NEAR(valueOf(found, "yaw_rate_second_peak_lag"), kYawLag, tolerance) << rate;
            EXPECT_NEAR(valueOf(found, "ay_first_peak_lag"), kAyLag, tolerance) << rate;
            EXPECT_NEAR(valueOf(found, "ay_second_peak_lag"), kAyLag, tolerance) << rate;
            EXPECT_NEAR(valueOf(found, "yaw_rate_gain"), 0.3, 1e-5);
            EXPECT_NEAR(valueOf(found, "ay_gain"), 9, 1e-4);
        }
    }
}

TEST(SineSteer, MeasurementNoiseMovesTheMetricsLittle) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Log log = continuousLog(100, 0.5, 5), one = onePeriodLog(100, 0.5);
        for (Log* noisy : {&log, &one}) {
            addNoise(*noisy, "chassis.yaw_rate", 0.0016, seed);
            addNoise(*noisy, "chassis.ay", 0.036, seed + 100);
            addNoise(*noisy, "driver.steering_wheel_angle", 0.002, seed + 200);
        }
        const double omega = std::numbers::pi;
        const auto found = metrics(log, "sine_steer");
        EXPECT_NEAR(valueOf(found, "yaw_rate_gain") / std::abs(secondOrder(omega)), 1, 0.005) << seed;
        EXPECT_NEAR(valueOf(found, "yaw_rate_phase_lag"), lagOf(secondOrder(omega)), 0.5) << seed;
        EXPECT_NEAR(valueOf(found, "ay_phase_lag"), lagOf(firstOrder(omega)), 0.5) << seed;
        EXPECT_NEAR(valueOf(metrics(one, "sine_steer"), "yaw_rate_first_peak_lag"), kYawLag, 0.03) << seed;
    }
}

TEST(SineSteer, WhatIsNoSineIsRefusedWithTheReason) {
    const auto steered = [](const std::function<double(double)>& angle) {
        Log log = continuousLog(100, 0.5, 5);
        for (std::size_t i = 0; i < log.samples(); ++i) log.channels[1].values[i] = angle(log.channels[0].values[i]);
        return errorOf(log, "sine_steer");
    };
    EXPECT_NE(steered(constant(0.1)).find("expected at least 1.1 deg"), std::string::npos);
    const auto sweep = [](double t) { return 0.4 * std::sin(0.8 * t * t); };
    EXPECT_NE(steered(sweep).find("expected one frequency"), std::string::npos) << steered(sweep);
    const auto steps = [](double t) { return t < 2 ? 0.0 : t < 4 ? 0.4 : t < 6 ? -0.4 : 0.0; };
    EXPECT_NE(steered(steps).find("departs from a sine"), std::string::npos) << steered(steps);
    // Sine with dwell: 0.7 Hz, 0.5 s dwell at three quarters of the period.
    const auto dwell = [](double t) {
        const double within = t - 1, period = 1 / 0.7;
        if (within < 0 || within > period + 0.5) return 0.0;
        const double at = within < 0.75 * period ? within : std::max(0.75 * period, within - 0.5);
        return 0.4 * std::sin(2 * std::numbers::pi * 0.7 * at);
    };
    EXPECT_NE(steered(dwell).find("departs from a sine"), std::string::npos) << steered(dwell);
}

}  // namespace
}  // namespace tread::metrics_sine_steer_test
