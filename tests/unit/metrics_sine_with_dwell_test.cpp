#include <gtest/gtest.h>

#include <cmath>

#include "scenario/signals.h"
#include "unit/metrics_sample.h"

namespace tread::metrics_sine_with_dwell_test {
namespace {

using sample::errorOf;
using sample::kDegree;
using sample::kRates;
using sample::valueOf;

constexpr double kBegin = 1.2, kFrequency = 0.7, kDwell = 0.5, kEnd = kBegin + 1 / kFrequency + kDwell;
constexpr double kPeak = 0.6;     // rad/s
constexpr double kDisplaced = 3;  // m/s2, lateral acceleration from the beginning on

double steering(double t, double amplitude) {
    return t < kBegin ? 0.02
                      : valueAt(SteeringSignal{SineWithDwell<Angle>{amplitude, kFrequency, kDwell}}, 0.02, t - kBegin);
}

// The yaw rate follows the steering, and dies out from half its peak with a time constant; the car moves aside with
// constant acceleration.
Log logOf(double rate, double amplitude, double time_constant, bool with_position = true) {
    const double sign = amplitude > 0 ? 1 : -1;
    const auto yaw_rate = [=](double t) {
        if (t < kEnd) return kPeak * (steering(t, amplitude) - 0.02) / std::abs(amplitude);
        return -sign * 0.5 * kPeak * std::exp(-(t - kEnd) / time_constant);
    };
    const auto aside = [=](double t) { return t < kBegin ? 0 : sign * 0.5 * kDisplaced * (t - kBegin) * (t - kBegin); };
    constexpr double kHeading = 0.7;
    std::vector<sample::Signal> signals{
        {"driver.steering_wheel_angle", "rad", [=](double t) { return steering(t, amplitude); }},
        {"chassis.vx", "m/s", sample::constant(22.2)},
        {"chassis.yaw_rate", "rad/s", yaw_rate},
        {"chassis.ay", "m/s2", [=](double t) { return 0.1 + (t < kBegin ? 0 : sign * kDisplaced); }},
        {"chassis.sideslip", "rad", [](double t) { return 0.1 * std::exp(-10 * (t - 2.3) * (t - 2.3)); }}};
    if (with_position) {
        signals.push_back({"chassis.x", "m",
                           [=](double t) { return 22.2 * t * std::cos(kHeading) - aside(t) * std::sin(kHeading); }});
        signals.push_back({"chassis.y", "m",
                           [=](double t) { return 22.2 * t * std::sin(kHeading) + aside(t) * std::cos(kHeading); }});
        signals.push_back({"chassis.yaw", "rad", sample::constant(kHeading)});
    }
    return sample::log(rate, 7, signals);
}

TEST(SineWithDwell, ReadsYawRateAndDisplacementAtTheTimesOfTheRule) {
    for (const double rate : kRates) {
        for (const double amplitude : {2.0, -2.0}) {
            for (const bool position : {true, false}) {
                const auto found = metrics(logOf(rate, amplitude, 0.8, position), "sine_with_dwell");
                const double late = 2 * 0.5 / rate;  // corners between samples
                EXPECT_NEAR(valueOf(found, "steering_amplitude"), 2 / kDegree, 0.2);
                EXPECT_NEAR(valueOf(found, "frequency"), kFrequency, 0.01) << rate;
                EXPECT_NEAR(valueOf(found, "dwell"), kDwell, 0.01 + late) << rate;
                EXPECT_NEAR(valueOf(found, "peak_yaw_rate"), kPeak / kDegree, 0.1) << rate;
                EXPECT_NEAR(valueOf(found, "yaw_rate_ratio_1.00s"), 0.5 * std::exp(-1 / 0.8), 0.005) << rate;
                EXPECT_NEAR(valueOf(found, "yaw_rate_ratio_1.75s"), 0.5 * std::exp(-1.75 / 0.8), 0.005) << rate;
                EXPECT_NEAR(valueOf(found, "lateral_displacement"), 0.5 * kDisplaced * 1.07 * 1.07, 0.05)
                    << rate << position;
                EXPECT_NEAR(valueOf(found, "largest_sideslip"), 0.1 / kDegree, 1e-3);
                EXPECT_EQ(valueOf(found, "stable"), 1);
                EXPECT_EQ(valueOf(found, "responsive"), 0) << "1.72 m";
                EXPECT_EQ(valueOf(found, "responsive_heavy"), 1);
            }
        }
    }
}

TEST(SineWithDwell, ACarThatGoesOnTurningIsUnstable) {
    // 0.5 exp(-1/2) = 0.303 passes the first limit, 0.5 exp(-1.75/2) = 0.208 fails the second.
    const auto second = metrics(logOf(100, 2, 2), "sine_with_dwell");
    EXPECT_LT(valueOf(second, "yaw_rate_ratio_1.00s"), 0.35);
    EXPECT_GT(valueOf(second, "yaw_rate_ratio_1.75s"), 0.20);
    EXPECT_EQ(valueOf(second, "stable"), 0);
    EXPECT_EQ(valueOf(metrics(logOf(100, 2, 5), "sine_with_dwell"), "stable"), 0);
}

TEST(SineWithDwell, ReadsThroughNoise) {
    Log log = logOf(100, 2, 0.8);
    sample::addNoise(log, "driver.steering_wheel_angle", 0.005, 1);
    sample::addNoise(log, "chassis.yaw_rate", 0.005, 2);
    const auto found = metrics(log, "sine_with_dwell");
    EXPECT_NEAR(valueOf(found, "yaw_rate_ratio_1.00s"), 0.5 * std::exp(-1 / 0.8), 0.02);
    EXPECT_NEAR(valueOf(found, "dwell"), kDwell, 0.05);
}

TEST(SineWithDwell, WithoutDwellOrWithoutTheTimeAfterItIsRefused) {
    const auto sine = [](double t) { return t < 1 ? 0 : valueAt(SteeringSignal{Sine<Angle>{2, 0.7, 1}}, 0, t - 1); };
    Log log = logOf(100, 2, 0.8);
    auto& values = sample::channel(log, "driver.steering_wheel_angle").values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = sine(log.channels[0].values[i]);
    EXPECT_NE(errorOf(log, "sine_with_dwell").find("dwells for"), std::string::npos);

    Log cut = logOf(100, 2, 0.8);
    for (Channel& channel : cut.channels) channel.values.resize(static_cast<std::size_t>(100 * (kEnd + 1.5)));
    EXPECT_NE(errorOf(cut, "sine_with_dwell").find("after completion of steer, expected 1.75 s"), std::string::npos);
}

}  // namespace
}  // namespace tread::metrics_sine_with_dwell_test
