// Vibration that references lack: found where a motion is added to noise at one frequency, not where the noise is the
// same or grows at all frequencies.
#include "diagnose/select/vibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/math/random.h"

namespace tread::diagnose_vibration_test {
namespace {

using diagnose::answer::Vibration;
using diagnose::select::vibrationOf;
using recording::Recorded;

constexpr double kRate = 100;  // Hz
constexpr int kDrives = 6;
constexpr double kNoise = 0.02, kSlow = 3;

struct Shake {
    double frequency = 0, amplitude = 0;  // Hz; m/s2
    double rougher = 1;                   // factor on the noise
};

// A slow manoeuvre with noise; the yaw rate has a hundredth of it all.
Log drive(Random& random, const Shake& shake, double duration) {
    const double phase = 2 * std::numbers::pi * random.uniform();
    Log log{{{"time", "s", {}}, {"chassis.ay", "m/s2", {}}, {"chassis.yaw_rate", "rad/s", {}}}};
    for (int i = 0; i <= static_cast<int>(duration * kRate); ++i) {
        const double t = i / kRate;
        const double motion = kSlow * std::sin(2 * std::numbers::pi * 0.3 * t) +
                              shake.amplitude * std::sin(2 * std::numbers::pi * shake.frequency * t + phase);
        const double noise = kNoise * shake.rougher;
        log.channels[0].values.push_back(t);
        log.channels[1].values.push_back(motion + noise * random.normal());
        log.channels[2].values.push_back(0.01 * (motion + noise * random.normal()));
    }
    return log;
}

Recorded drives(std::uint64_t seed, const Shake& shake, double duration = 12) {
    Random random(seed);
    Recorded recorded;
    for (int i = 0; i < kDrives; ++i) {
        recorded.references.push_back(drive(random, {}, duration));
        recorded.logs.push_back(drive(random, shake, duration));
    }
    return recorded;
}

bool isNone(const Vibration& vibration) {
    return vibration.frequency == 0 && vibration.growth.empty() && vibration.gain == 0;
}

TEST(Vibration, IsFoundAtItsFrequencyInTheChannelsThatShowIt) {
    for (const double frequency : {4.0, 7.0, 13.0, 19.0}) {
        const Vibration found = vibrationOf(drives(1, {frequency, 0.1}));
        EXPECT_EQ(found.frequency, frequency);
        EXPECT_GT(found.gain, 6);
        ASSERT_EQ(found.growth.size(), 2u);
        // Power of noise in a Hann window: 3/8 of the variance times the samples; of the sine: a sixteenth of the
        // square of amplitude and samples. The median of an exponential distribution is ln 2 of its mean.
        const double sine = std::pow(0.1 * kRate, 2) / 16, noise = 0.375 * kNoise * kNoise * kRate * std::numbers::ln2;
        EXPECT_NEAR(found.growth.at("chassis.ay"), std::sqrt(sine / noise), 0.25 * std::sqrt(sine / noise));
    }
}

TEST(Vibration, IsNotSeenInDrawnCarsWithoutOne) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) EXPECT_TRUE(isNone(vibrationOf(drives(seed, {})))) << seed;
}

TEST(Vibration, IsNotARougherRoad) {
    EXPECT_TRUE(isNone(vibrationOf(drives(1, {.rougher = 10}))));
    EXPECT_TRUE(isNone(vibrationOf(drives(1, {.rougher = 0.1}))));
}

// Eight other frequencies differ from the references as much as 7 Hz does, some in one direction, some in the other.
TEST(Vibration, IsNoneWhereManyFrequenciesDifferAsMuch) {
    Recorded recorded = drives(1, {7, 0.016});
    EXPECT_EQ(vibrationOf(recorded).frequency, 7);
    EXPECT_GT(vibrationOf(recorded).gain, 6);
    for (const double frequency : {3.0, 4., 10., 11., 14., 15., 18., 19.}) {
        for (std::vector<Log>* logs : {&recorded.logs, &recorded.references}) {
            const bool later = std::fmod(frequency, 2) == 0;
            if ((logs == &recorded.logs) != later) continue;
            for (Log& log : *logs)
                for (std::size_t i = 0; i < log.samples(); ++i) {
                    const double more = 0.016 * std::sin(2 * std::numbers::pi * frequency * log.channels[0].values[i]);
                    log.channels[1].values[i] += more;
                    log.channels[2].values[i] += 0.01 * more;
                }
        }
    }
    EXPECT_TRUE(isNone(vibrationOf(recorded)));
}

TEST(Vibration, ThatEndedIsNone) {
    Recorded recorded = drives(1, {7, 0.1});
    std::swap(recorded.logs, recorded.references);
    EXPECT_TRUE(isNone(vibrationOf(recorded)));
}

TEST(Vibration, OfOneDriveAmongManyIsNotThatOfTheCar) {
    Recorded recorded = drives(1, {7, 0.1});
    for (int i = 1; i < kDrives; ++i) recorded.logs[i] = recorded.references[i];
    EXPECT_TRUE(isNone(vibrationOf(recorded)));
}

TEST(Vibration, NeedsReferencesOfThreeWindows) {
    Recorded alone = drives(1, {7, 0.1});
    alone.references.assign(kDrives, Log{});
    EXPECT_TRUE(isNone(vibrationOf(alone)));
    alone.references.clear();
    EXPECT_TRUE(isNone(vibrationOf(alone)));
    EXPECT_TRUE(isNone(vibrationOf(drives(1, {7, 0.1}, 1.6))));
    EXPECT_FALSE(isNone(vibrationOf(drives(1, {7, 0.1}, 2.2))));
}

TEST(Vibration, IsSoughtOnlyWhereSamplesShowIt) {
    Recorded slow = drives(1, {13, 0.1});
    for (std::vector<Log>* logs : {&slow.logs, &slow.references})
        for (Log& log : *logs)
            for (Channel& channel : log.channels) {
                std::vector<double> kept;
                for (std::size_t i = 0; i < channel.values.size(); i += 5) kept.push_back(channel.values[i]);
                channel.values = std::move(kept);
            }
    // At 20 Hz, 13 Hz looks like 7 Hz.
    EXPECT_EQ(vibrationOf(slow).frequency, 7);
    for (std::vector<Log>* logs : {&slow.logs, &slow.references})
        for (Log& log : *logs)
            for (double& t : log.channels[0].values) t *= 2;  // 10 Hz: no four frequencies up to 4 Hz
    EXPECT_TRUE(isNone(vibrationOf(slow)));
}

TEST(Vibration, OfWindowsWithGapsIsThatOfTheOthers) {
    Recorded recorded = drives(1, {7, 0.1});
    for (Log& log : recorded.logs)
        for (int i = 150; i < 420; ++i) log.channels[1].values[i] = std::nan("");
    const Vibration found = vibrationOf(recorded);
    EXPECT_EQ(found.frequency, 7);
    EXPECT_EQ(found.growth.size(), 2u);
}

}  // namespace
}  // namespace tread::diagnose_vibration_test
