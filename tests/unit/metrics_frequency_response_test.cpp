#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "metrics/frequency_response.h"
#include "scenario/signals.h"
#include "shared/linear_single_track.h"
#include "unit/metrics_sample.h"

namespace tread::metrics_frequency_response_test {
namespace {

using sample::errorOf;
using sample::kDegree;
using sample::kRates;
using sample::valueOf;

constexpr std::array kFrequencies{0.2, 0.5, 1.0, 1.5, 2.0};

std::function<double(double)> signalFrom(const SteeringSignal& signal, double begin) {
    return [=](double t) { return t < begin ? 0 : valueAt(signal, 0, t - begin); };
}

struct Input {
    const char* name;
    SteeringSignal signal;
    double duration;  // s
};
const std::array<Input, 3> kInputs{
    Input{"sweep", Sweep<Angle>{0.2, 0.1, 4, 40, SweepLaw::logarithmic}, 46},
    Input{"pulse", Pulse<Angle>{0.5, 0.4}, 8},
    Input{"random", Noise<Angle>{0.1, 0.15, 2.5, 150, 3}, 240},
};

// Tolerances: the random signal is cut by windows of 20 s, in which a response that lags leaks by its lag over 20 s;
// corners between samples at 50 Hz cost (pi f dt)^2 / 3.
TEST(FrequencyResponse, IsThatOfTheSingleTrackModel) {
    const shared::SingleTrack car;
    for (const Input& input : kInputs) {
        const bool random = std::string(input.name) == "random";
        const double leak = random ? 0.01 : 0.004, angle = random ? 1 : 0.5;
        for (const double rate : kRates) {
            if (random && rate > 100) continue;
            const Log log = car.drive(signalFrom(input.signal, 1), input.duration, rate, random ? 0.01 : 0.001);
            const auto found = metrics(log, "frequency_response");
            for (const double f : kFrequencies) {
                const auto expected = car.at(f);
                char at[16];
                std::snprintf(at, sizeof at, "_%.1fHz", f);
                const double corner = 3.15 * f / rate, share = leak + corner * corner / 3;
                const std::string where = std::string(input.name) + at + " rate " + std::to_string(rate);
                EXPECT_NEAR(valueOf(found, std::string("yaw_rate_gain") + at), std::abs(expected.yaw_rate),
                            share * std::abs(expected.yaw_rate))
                    << where;
                EXPECT_NEAR(valueOf(found, std::string("yaw_rate_phase_lag") + at),
                            -std::arg(expected.yaw_rate) / kDegree, angle)
                    << where;
                EXPECT_NEAR(valueOf(found, std::string("ay_gain") + at), std::abs(expected.ay),
                            share * std::abs(expected.ay))
                    << where;
                EXPECT_NEAR(valueOf(found, std::string("ay_phase_lag") + at), -std::arg(expected.ay) / kDegree, angle)
                    << where;
                if (std::string(input.name) != "pulse") {
                    EXPECT_GT(valueOf(found, std::string("yaw_rate_coherence") + at), 0.995) << where;
                }
            }
            EXPECT_EQ(valueOf(found, "segments") > 1, random) << input.name;
            EXPECT_NEAR(valueOf(found, "speed"), car.speed, 1e-6);
        }
    }
}

TEST(FrequencyResponse, ResonanceAndBandwidthAreThoseOfTheSingleTrackModel) {
    shared::SingleTrack car;
    car.inertia = 4000;  // slow to turn: a clear resonance
    car.speed = 35;
    const auto found = metrics(car.drive(signalFrom(kInputs[0].signal, 1), 46, 100), "frequency_response");
    const auto gain = [&](double f) { return std::abs(car.at(f).yaw_rate); };
    double peak = 0.1, bandwidth = 0;
    for (double f = 0.1; f < 4; f += 0.001) {
        if (gain(f) > gain(peak)) peak = f;
        if (bandwidth == 0 && gain(f) < gain(0.1) / std::sqrt(2.0)) bandwidth = f;
    }
    EXPECT_NEAR(valueOf(found, "yaw_rate_peak_frequency"), peak, 0.05);  // the raster
    EXPECT_NEAR(valueOf(found, "yaw_rate_peak_ratio"), gain(peak) / gain(0.1), 0.01);
    EXPECT_NEAR(valueOf(found, "yaw_rate_bandwidth"), bandwidth, 0.02);
}

// Noise of the sensor that is a known share of its power: coherence = signal / (signal + noise), H1 keeps its gain.
TEST(FrequencyResponse, CoherenceTellsTheShareOfTheNoise) {
    const shared::SingleTrack car;
    constexpr double kRate = 50, kLowest = 0.15, kHighest = 2.5, kRms = 0.1, kNoise = 0.03;
    Log log = car.drive(signalFrom(Noise<Angle>{kRms, kLowest, kHighest, 100, 3}, 0), 600, kRate, 0.01);
    sample::addNoise(log, "chassis.yaw_rate", kNoise, 1);
    const auto found = metrics(log, "frequency_response");
    for (const double f : {0.5, 1.0, 2.0}) {
        const double signal = std::norm(car.at(f).yaw_rate) * kRms * kRms / (kHighest - kLowest);  // per Hz, one-sided
        const double noise = kNoise * kNoise * 2 / kRate;
        char at[16];
        std::snprintf(at, sizeof at, "_%.1fHz", f);
        EXPECT_NEAR(valueOf(found, std::string("yaw_rate_coherence") + at), signal / (signal + noise), 0.05) << f;
        EXPECT_NEAR(valueOf(found, std::string("yaw_rate_gain") + at), std::abs(car.at(f).yaw_rate),
                    0.05 * std::abs(car.at(f).yaw_rate))
            << f;
    }
}

TEST(FrequencyResponse, WhatTheSteeringDoesNotAskHasNoAnswer) {
    const shared::SingleTrack car;
    const auto found = metrics(car.drive(signalFrom(kInputs[2].signal, 0), 120, 50, 0.01), "frequency_response");
    EXPECT_TRUE(std::isnan(valueOf(found, "yaw_rate_gain_3.0Hz")));
    EXPECT_TRUE(std::isfinite(valueOf(found, "yaw_rate_gain_2.0Hz")));
}

TEST(FrequencyResponse, ASineAStepAndNothingAreNoBroadBand) {
    const shared::SingleTrack car;
    EXPECT_NE(errorOf(car.drive([](double) { return 0; }, 30, 50), "frequency_response").find("moves by only 0 deg"),
              std::string::npos);
    EXPECT_NE(errorOf(car.drive([](double t) { return t < 1 ? 0 : 0.5; }, 30, 50), "frequency_response")
                  .find("does not end where it began"),
              std::string::npos);
    EXPECT_NE(errorOf(car.drive(signalFrom(Sine<Angle>{0.3, 0.5}, 0), 60, 50), "frequency_response")
                  .find("expected a broad band"),
              std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_frequency_response_test
