#include "recording/driver_inputs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math/random.h"

namespace tread::driver_inputs_test {
namespace {

using recording::followedSpeed;
using recording::quietened;
using recording::quietInputs;
using recording::RecordedDrive;

constexpr double kNoise = 0.002;  // rad

// A steering wheel at rest, turned in 100 ms at second 5, then held: at 100 Hz.
double turned(double t) {
    return t < 5 ? 0 : t < 5.1 ? 8 * (t - 5) : 0.8;
}

double deviation(const std::vector<double>& values, double from, double to) {
    double sum = 0, n = 0;
    for (double t = from; t < to; t += 0.01, n += 1) {
        const double off = values[static_cast<std::size_t>(std::lround(100 * t))] - turned(t);
        sum += off * off;
    }
    return std::sqrt(sum / n);
}

TEST(QuietInputs, SteeringWheelAtRestKeepsAFifthOfTheNoiseAndAQuickTurnStaysAsItWas) {
    double shown_squares = 0, quiet_squares = 0;
    constexpr int kRuns = 20;
    for (int run = 0; run < kRuns; ++run) {
        Random random(static_cast<std::uint64_t>(run));
        std::vector<double> shown;
        for (int i = 0; i < 1000; ++i) shown.push_back(turned(0.01 * i) + kNoise * random.normal());
        const std::vector<double> quiet = quietened(shown);
        shown_squares += std::pow(deviation(shown, 1, 4), 2);
        quiet_squares += std::pow(deviation(quiet, 1, 4), 2) / 2 + std::pow(deviation(quiet, 6, 9), 2) / 2;
        EXPECT_LT(deviation(quiet, 4.9, 5.2), 1.5 * kNoise);
    }
    EXPECT_NEAR(std::sqrt(shown_squares / kRuns), kNoise, 0.05 * kNoise);
    EXPECT_LT(std::sqrt(quiet_squares / kRuns), 0.2 * kNoise);
}

TEST(QuietInputs, SweepUpToThreePeriodsASecondIsNotFlattened) {
    Random random(2);
    std::vector<double> shown, real;
    for (int i = 0; i < 1000; ++i) {
        const double t = 0.01 * i;
        real.push_back(0.35 * std::sin(2 * M_PI * (0.2 + 0.15 * t) * t));
        shown.push_back(real.back() + kNoise * random.normal());
    }
    const std::vector<double> quiet = quietened(shown);
    double off = 0, slope = 0, square = 0;
    for (std::size_t i = 0; i < real.size(); ++i) {
        off = std::max(off, std::abs(quiet[i] - real[i]));
        slope += quiet[i] * real[i], square += real[i] * real[i];
    }
    EXPECT_LT(off, 5 * kNoise);
    EXPECT_NEAR(slope / square, 1, 1e-3);
}

TEST(QuietInputs, WhatHasNoNoiseOrGapsIsKept) {
    std::vector<double> held(100, 0.3);
    EXPECT_EQ(quietened(held), held);
    std::vector<double> gaps(100, NAN);
    for (std::size_t i = 0; i < gaps.size(); i += 2) gaps[i] = 0.1;
    const std::vector<double> kept = quietened(gaps);
    for (std::size_t i = 0; i < gaps.size(); ++i) EXPECT_EQ(std::isnan(kept[i]), std::isnan(gaps[i])) << i;
}

// Its slope times the mass of the car is the force of the follower. One second about a sample determines the slope to
// 0.01 m/s2, a second at the end of which it lies to 0.04 m/s2, and a fifth of a second there to 0.45 m/s2.
TEST(FollowedSpeed, IsQuietAlsoAtTheEndsOfTheDrive) {
    constexpr int kRuns = 40, kSamples = 500;
    double squares_first = 0, squares_last = 0;
    for (int run = 0; run < kRuns; ++run) {
        Random random(static_cast<std::uint64_t>(run));
        RecordedDrive drive;
        drive.log = {{{"time", "s", {}}, {"chassis.vx", "m/s", {}}}};
        for (int i = 0; i < kSamples; ++i) {
            drive.log.channels[0].values.push_back(0.01 * i);
            drive.log.channels[1].values.push_back(22 + 0.03 * random.normal());
        }
        drive.time = drive.log.channels[0].values;
        drive.inputs = quietInputs(drive.log);
        const std::vector<Curve::Point> speed = followedSpeed(drive, {}).points;
        ASSERT_EQ(speed.size(), kSamples);
        squares_first += std::pow((speed[10].y - speed[0].y) / 0.1, 2);
        squares_last += std::pow((speed[kSamples - 1].y - speed[kSamples - 11].y) / 0.1, 2);
    }
    EXPECT_LT(std::sqrt(squares_first / kRuns), 0.06);
    EXPECT_LT(std::sqrt(squares_last / kRuns), 0.06);
}

}  // namespace
}  // namespace tread::driver_inputs_test
