#include "scenario/signals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tread::scenario_signals_test {
namespace {

constexpr double kHeld = 0.3;  // where the phase before left hand or foot
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRounding = 1e-12;

TEST(Signals, KeepStaysWhereItWas) {
    for (const double elapsed : {0.0, 1.0, 1e6}) {
        EXPECT_EQ(valueAt(SteeringSignal{Keep{}}, kHeld, elapsed), kHeld);
        EXPECT_EQ(valueAt(PedalSignal{Keep{}}, kHeld, elapsed), kHeld);
        EXPECT_EQ(valueAt(ThrottleSignal{Keep{}}, kHeld, elapsed), kHeld);
    }
}

TEST(Signals, ConstantHasItsValueFromTheFirstMoment) {
    for (const double elapsed : {0.0, 1.0, 1e6}) {
        EXPECT_EQ(valueAt(SteeringSignal{Constant<Angle>{-2}}, kHeld, elapsed), -2);
        EXPECT_EQ(valueAt(PedalSignal{Constant<Pedal>{0.8}}, kHeld, elapsed), 0.8);
        EXPECT_EQ(valueAt(ThrottleSignal{Constant<Pedal>{0.8}}, kHeld, elapsed), 0.8);
    }
}

TEST(Signals, RampGoesFromWhereItWasToItsEndAtItsRate) {
    const SteeringSignal up = Ramp<Angle>{1.3, 2};  // one radian at 2 rad/s
    EXPECT_EQ(valueAt(up, kHeld, 0), kHeld);
    EXPECT_NEAR(valueAt(up, kHeld, 0.25), 0.8, kRounding);
    EXPECT_EQ(valueAt(up, kHeld, 0.5), 1.3);
    EXPECT_EQ(valueAt(up, kHeld, 100), 1.3);

    const SteeringSignal down = Ramp<Angle>{-0.7, 2};
    EXPECT_EQ(valueAt(down, kHeld, 0), kHeld);
    EXPECT_NEAR(valueAt(down, kHeld, 0.25), -0.2, kRounding);
    EXPECT_EQ(valueAt(down, kHeld, 0.5), -0.7);
    EXPECT_EQ(valueAt(down, kHeld, 100), -0.7);
}

TEST(Signals, RampToWhereItIsStays) {
    for (const double elapsed : {0.0, 1.0}) {
        EXPECT_EQ(valueAt(PedalSignal{Ramp<Pedal>{kHeld, 5}}, kHeld, elapsed), kHeld);
    }
}

TEST(Signals, PedalsRampLikeTheSteeringWheel) {
    EXPECT_NEAR(valueAt(PedalSignal{Ramp<Pedal>{1, 10}}, 0, 0.05), 0.5, kRounding);
    EXPECT_NEAR(valueAt(ThrottleSignal{Ramp<Pedal>{0, 10}}, 1, 0.05), 0.5, kRounding);
}

TEST(Signals, SineSwingsAboutWhereItWasAndEndsThere) {
    const SteeringSignal sine = Sine<Angle>{0.5, 2, 1.5};  // one and a half periods of half a second
    EXPECT_EQ(valueAt(sine, kHeld, 0), kHeld);
    EXPECT_NEAR(valueAt(sine, kHeld, 0.125), kHeld + 0.5, kRounding);
    EXPECT_NEAR(valueAt(sine, kHeld, 0.375), kHeld - 0.5, kRounding);
    EXPECT_NEAR(valueAt(sine, kHeld, 0.625), kHeld + 0.5, kRounding);
    EXPECT_EQ(valueAt(sine, kHeld, 0.75), kHeld);
    EXPECT_EQ(valueAt(sine, kHeld, 0.875), kHeld);
}

TEST(Signals, SineOfNegativeAmplitudeBeginsToTheRight) {
    EXPECT_NEAR(valueAt(SteeringSignal{Sine<Angle>{-0.5, 1}}, 0, 0.25), -0.5, kRounding);
}

TEST(Signals, SineWithoutNumberOfCyclesGoesOn) {
    EXPECT_NEAR(valueAt(SteeringSignal{Sine<Angle>{0.5, 1}}, kHeld, 1000.25), kHeld + 0.5, 1e-9);
}

// Integral of a frequency that rises linearly from f0 to f1 over T: f0 t + (f1 - f0) t^2 / (2 T) periods.
TEST(Signals, SweepRunsThroughItsFrequenciesLinearly) {
    const SteeringSignal sweep = Sweep<Angle>{0.5, 1, 3, 4};
    EXPECT_EQ(valueAt(sweep, kHeld, 0), kHeld);
    EXPECT_NEAR(valueAt(sweep, kHeld, 2), kHeld + 0.5 * std::sin(kTurn * (1 * 2 + 2 * 2 * 2 / 8.0)), kRounding);

    // Zero crossings tell the frequency: cos of the phase is the slope over 2 pi f A.
    const auto frequency = [&](double t, double phase) {
        constexpr double kStep = 1e-6;
        const double slope = (valueAt(sweep, 0, t + kStep) - valueAt(sweep, 0, t - kStep)) / (2 * kStep);
        return slope / (kTurn * 0.5 * std::cos(kTurn * phase));
    };
    const auto phaseAt = [](double t) { return t + t * t / 4; };
    EXPECT_NEAR(frequency(1e-6, phaseAt(1e-6)), 1, 1e-4);
    EXPECT_NEAR(frequency(2, phaseAt(2)), 2, 1e-4);
    EXPECT_NEAR(frequency(4 - 2e-6, phaseAt(4 - 2e-6)), 3, 1e-4);
}

TEST(Signals, SweepStaysWhereItBeganAfterItsEnd) {
    const SteeringSignal sweep = Sweep<Angle>{0.5, 1, 3, 4.1};
    EXPECT_NE(valueAt(sweep, kHeld, 4.099), kHeld);
    EXPECT_EQ(valueAt(sweep, kHeld, 4.1), kHeld);
    EXPECT_EQ(valueAt(sweep, kHeld, 100), kHeld);
}

TEST(Signals, SweepMayFall) {
    const SteeringSignal falling = Sweep<Angle>{0.5, 3, 1, 4};
    EXPECT_NEAR(valueAt(falling, 0, 1), 0.5 * std::sin(kTurn * (3 - 0.25)), kRounding);
}

// Every second multiplies the frequency by the same factor: (e^(k t) - 1) f0 / k periods, k = ln(f1 / f0) / T.
TEST(Signals, LogarithmicSweepMultipliesItsFrequency) {
    const SteeringSignal sweep = Sweep<Angle>{0.5, 0.2, 3.2, 8, SweepLaw::logarithmic};  // an octave in two seconds
    const double k = std::log(2.0) / 2;
    for (const double t : {0.5, 2.0, 6.3}) {
        EXPECT_NEAR(valueAt(sweep, kHeld, t), kHeld + 0.5 * std::sin(kTurn * 0.2 * (std::exp(k * t) - 1) / k), 1e-10);
    }
    EXPECT_EQ(valueAt(sweep, kHeld, 8), kHeld);
    // From one frequency to the same, both laws are a sine.
    EXPECT_NEAR(valueAt(SteeringSignal{Sweep<Angle>{0.5, 1, 1, 4, SweepLaw::logarithmic}}, 0, 1.25), 0.5, kRounding);
}

TEST(Signals, SineWithDwellWaitsAtItsSecondPeak) {
    const SteeringSignal sine = SineWithDwell<Angle>{2, 0.7, 0.5};
    const double period = 1 / 0.7;
    EXPECT_NEAR(valueAt(sine, kHeld, 0.25 * period), kHeld + 2, kRounding);
    EXPECT_NEAR(valueAt(sine, kHeld, 0.5 * period), kHeld, kRounding);
    for (const double wait : {0.0, 0.1, 0.25, 0.5})
        EXPECT_NEAR(valueAt(sine, kHeld, 0.75 * period + wait), kHeld - 2, kRounding) << wait;
    EXPECT_NEAR(valueAt(sine, kHeld, (11.0 / 12) * period + 0.5), kHeld - 1, kRounding);  // sin(330 deg)
    EXPECT_EQ(valueAt(sine, kHeld, period + 0.5 + 1e-9), kHeld);
    EXPECT_NEAR(valueAt(SteeringSignal{SineWithDwell<Angle>{-2, 0.7, 0.5}}, 0, 0.75 * period + 0.3), 2, kRounding);
}

TEST(Signals, PulseIsATriangle) {
    const SteeringSignal pulse = Pulse<Angle>{0.4, 0.5};
    EXPECT_EQ(valueAt(pulse, kHeld, 0), kHeld);
    EXPECT_NEAR(valueAt(pulse, kHeld, 0.125), kHeld + 0.2, kRounding);
    EXPECT_NEAR(valueAt(pulse, kHeld, 0.25), kHeld + 0.4, kRounding);
    EXPECT_NEAR(valueAt(pulse, kHeld, 0.375), kHeld + 0.2, kRounding);
    EXPECT_EQ(valueAt(pulse, kHeld, 0.5), kHeld);
    EXPECT_EQ(valueAt(pulse, kHeld, 9), kHeld);
}

TEST(Signals, RandomHasItsPowerInItsBandAndNowhereElse) {
    const SteeringSignal random = Noise<Angle>{0.1, 0.2, 2, 120, 7};
    constexpr double kRate = 20, kTime = 400;
    double squares = 0, sum = 0, outside = 0;
    std::vector<double> values;
    for (double t = 2; t < kTime; t += 1 / kRate) values.push_back(valueAt(random, 0, t));
    for (double value : values) {
        sum += value;
        squares += value * value;
    }
    const auto n = static_cast<double>(values.size());
    EXPECT_NEAR(std::sqrt(squares / n), 0.1, 0.004) << "sines of 120 frequencies beat slowly";
    EXPECT_NEAR(sum / n, 0, 0.001);
    // Amplitude of the Fourier sum well outside of the band, against an rms of 0.1.
    for (const double frequency : {0.05, 2.5, 5.0}) {
        double re = 0, im = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double hann = 1 - std::cos(kTurn * static_cast<double>(i) / n);
            re += hann * values[i] * std::cos(kTurn * frequency * static_cast<double>(i) / kRate);
            im += hann * values[i] * std::sin(kTurn * frequency * static_cast<double>(i) / kRate);
        }
        outside = std::max(outside, 2 * std::hypot(re, im) / n);
    }
    EXPECT_LT(outside, 1e-4);
}

TEST(Signals, RandomIsItsSeeds) {
    const auto of = [](int seed, double t) {
        return valueAt(SteeringSignal{Noise<Angle>{0.1, 0.2, 2, 120, seed}}, kHeld, t);
    };
    EXPECT_EQ(of(1, 0), kHeld) << "begins without a jump";
    EXPECT_EQ(of(1, 3.3), of(1, 3.3));
    EXPECT_NE(of(1, 3.3), of(2, 3.3));
}

TEST(Signals, TableIsReadOverTheTimeOfThePhaseAndHeldBeyondItsEnds) {
    const Curve points{{{0.5, 1}, {1.5, -1}}};
    for (const auto& read :
         {+[](const Curve&curve, double t) { return valueAt(SteeringSignal{Table<Angle>{curve}}, kHeld, t); },
          +[](const Curve&curve, double t) { return valueAt(PedalSignal{Table<Pedal>{curve}}, kHeld, t); },
          +[](const Curve&curve, double t) { return valueAt(ThrottleSignal{Table<Pedal>{curve}}, kHeld, t); }}) {
        EXPECT_EQ(read(points, 0), 1);
        EXPECT_EQ(read(points, 0.5), 1);
        EXPECT_NEAR(read(points, 1.25), -0.5, kRounding);
        EXPECT_EQ(read(points, 1.5), -1);
        EXPECT_EQ(read(points, 100), -1);
    }
}

TEST(Signals, HoldSpeedIsNoFunctionOfTime) {
    EXPECT_EQ(valueAt(ThrottleSignal{HoldSpeed{20}}, kHeld, 0), kHeld);
    EXPECT_EQ(valueAt(ThrottleSignal{HoldSpeed{20}}, kHeld, 100), kHeld);
}

}  // namespace
}  // namespace tread::scenario_signals_test
