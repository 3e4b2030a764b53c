#include "scenario/signals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tread {
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

TEST(Signals, PedalsRampLikeTheHandWheel) {
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
}  // namespace tread
