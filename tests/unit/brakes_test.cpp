#include "tread/brakes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::brakes_test {
namespace {

constexpr double kStep = 0.001;  // s

BrakeParams params() {
    BrakeParams p;
    p.full_pedal_torque = 5000;
    p.front_share = 0.7;
    return p;
}

double sum(const PerWheel<double>& t) {
    return t.front_left + t.front_right + t.rear_left + t.rear_right;
}

PerWheel<double> torquesAt(const BrakeParams& p, double pedal) {
    BrakeState state;
    return advance(state, p, {.pedal_begin = pedal, .pedal_end = pedal}, kStep).end;
}

// ---- Pedal, pressure, torque ----

TEST(Brakes, FourWheelsTogetherGiveTheFullTorqueAtFullPedal) {
    const PerWheel<double> wheel = torquesAt(params(), 1);
    EXPECT_DOUBLE_EQ(sum(wheel), 5000);
    EXPECT_DOUBLE_EQ(wheel.front_left + wheel.front_right, 3500);
    EXPECT_EQ(wheel.front_left, wheel.front_right);
    EXPECT_EQ(wheel.rear_left, wheel.rear_right);
}

TEST(Brakes, TorqueIsProportionalToThePedal) {
    EXPECT_EQ(sum(torquesAt(params(), 0)), 0);
    EXPECT_DOUBLE_EQ(torquesAt(params(), 0.25).front_left, 0.25 * torquesAt(params(), 1).front_left);
    EXPECT_DOUBLE_EQ(torquesAt(params(), 0.25).rear_left, 0.25 * torquesAt(params(), 1).rear_left);
}

TEST(Brakes, MeanOverTheStepLiesBetweenItsEnds) {
    BrakeState state;
    const BrakeTorques t = advance(state, params(), {.pedal_begin = 0.2, .pedal_end = 0.4}, kStep);
    EXPECT_DOUBLE_EQ(sum(t.end), 2000);
    EXPECT_DOUBLE_EQ(sum(t.mean), 1500);
}

TEST(Brakes, ProportioningValveBendsTheRearPressureAtItsKnee) {
    BrakeParams p = params();
    p.full_pedal_pressure = 1e7;
    p.rear_proportioning = {.knee = 3e6, .slope = 0.4};
    const double full = 0.5 * 5000 * 0.3;
    EXPECT_NEAR(torquesAt(p, 0.3).rear_left, 0.3 * full, 1e-9);
    EXPECT_NEAR(torquesAt(p, 0.8).rear_left, (0.3 + 0.4 * 0.5) * full, 1e-9);
    EXPECT_DOUBLE_EQ(torquesAt(p, 0.8).front_left, torquesAt(params(), 0.8).front_left);
}

TEST(Brakes, PressureFollowsAPushedPedalAfterTheDelayWithTheLagWhateverTheStep) {
    BrakeParams p = params();
    p.delay = 0.048;
    p.lag = 0.04;
    constexpr double kRate = 2;  // 1/s, of the pedal
    for (const double step : {0.001, 0.004}) {
        BrakeState state;
        for (int k = 1; k * step < 0.4; ++k) {
            const double t = k * step;
            const BrakeInput in{.pedal_begin = kRate * (t - step), .pedal_end = kRate * t};
            const double since = std::max(t - 0.048, 0.0);
            const double expected = 5000 * kRate * (since - 0.04 * (1 - std::exp(-since / 0.04)));
            EXPECT_NEAR(sum(advance(state, p, in, step).end), expected, 1e-6) << step << " " << t;
        }
    }
}

TEST(Brakes, ParkingBrakeHoldsTheRearWheels) {
    BrakeParams p = params();
    p.parking_torque = 1800;
    BrakeState state;
    const PerWheel<double> wheel = advance(state, p, {.parking_begin = 0.5, .parking_end = 0.5}, kStep).end;
    EXPECT_EQ(wheel.front_left, 0);
    EXPECT_DOUBLE_EQ(wheel.rear_left, 450);
    EXPECT_DOUBLE_EQ(wheel.rear_right, 450);
}

TEST(Brakes, DragActsOnItsWheelAloneWhateverThePedal) {
    for (const double pedal : {0.0, 0.5}) {
        BrakeState state;
        const PerWheel<double> free = torquesAt(params(), pedal);
        const BrakeTorques t =
            advance(state, params(), {.pedal_begin = pedal, .pedal_end = pedal, .drag = {0, 80, 0, 0}}, kStep);
        for (std::size_t i = 0; i < kWheels; ++i) EXPECT_DOUBLE_EQ(t.mean[i], free[i] + (i == 1 ? 80 : 0)) << i;
    }
}

TEST(Brakes, MotorTakesOverWhatItRecovers) {
    BrakeState state;
    const PerWheel<double> wheel =
        advance(state, params(), {.pedal_begin = 0.2, .pedal_end = 0.2, .recovered = {150, 400}}, kStep).end;
    EXPECT_DOUBLE_EQ(wheel.front_left, 350 - 150);
    EXPECT_EQ(wheel.rear_left, 0) << "a brake does not push";
}

// ---- Heat ----

TEST(Brakes, DiscWarmsToWhereItsCoolingTakesTheBrakingPower) {
    BrakeParams p = params();
    p.front_disc = {.heat_capacity = 3000, .cooling = 5, .cooling_by_speed = 0.8};
    p.rear_disc = {.heat_capacity = 0};
    BrakeState state;
    BrakeInput in{.pedal_begin = 0.1, .pedal_end = 0.1, .spin = {70, 70, 70, 70}};
    in.car.speed = 21;
    for (int k = 0; k < 20000; ++k) advance(state, p, in, 1);
    const double power = 0.1 * 5000 * 0.35 * 70;
    EXPECT_NEAR(state.heating.front_left, power / (5 + 0.8 * 21), 1e-6);
    EXPECT_EQ(state.heating.rear_left, 0) << "no heat capacity: stays cold";
}

TEST(Brakes, DiscKeepsTheEnergyOfAStopThatCoolingHasNoTimeToTake) {
    BrakeParams p = params();
    p.front_disc = {.heat_capacity = 3000};
    BrakeState state;
    double spin = 90, energy = 0;
    while (spin > 0) {
        const BrakeTorques t =
            advance(state, p, {.pedal_begin = 0.6, .pedal_end = 0.6, .spin = {spin, spin, 0, 0}}, kStep);
        energy += kStep * t.mean.front_left * spin;
        spin -= kStep * 20;
    }
    EXPECT_NEAR(3000 * state.heating.front_left, energy, 1e-9 * energy);
    EXPECT_GT(state.heating.front_left, 10);
}

TEST(Brakes, DiscCoolsExponentially) {
    BrakeParams p = params();
    p.rear_disc = {.heat_capacity = 2000, .cooling = 10};
    BrakeState state;
    state.heating.rear_right = 300;
    for (int k = 0; k < 100000; ++k) advance(state, p, {}, kStep);
    EXPECT_NEAR(state.heating.rear_right, 300 * std::exp(-100.0 * 10 / 2000), 0.01);
}

TEST(Brakes, HotDiscFades) {
    BrakeParams p = params();
    p.ambient_temperature = 300;
    p.front_disc = {.heat_capacity = 3000, .friction = {{{600, 1}, {1000, 0.5}}}};
    BrakeState state;
    state.heating.front_left = 500;
    const PerWheel<double> wheel = advance(state, p, {.pedal_begin = 1, .pedal_end = 1}, kStep).end;
    EXPECT_NEAR(wheel.front_left, 0.75 * wheel.front_right, 1e-9) << "800 K lies half-way";
}

TEST(Brakes, FadeLosesTorqueWithTheHeatingOfTheDisc) {
    BrakeParams p = params();
    p.rear_disc.fade = 0.001;
    BrakeState state;
    state.heating = {300, 300, 300, 0};
    const PerWheel<double> wheel = advance(state, p, {.pedal_begin = 1, .pedal_end = 1}, kStep).end;
    EXPECT_NEAR(wheel.rear_left, std::exp(-0.3) * wheel.rear_right, 1e-9);
    EXPECT_EQ(wheel.front_left, wheel.front_right) << "the front discs do not fade";
}

TEST(Brakes, ControllersWithHalfTheAuthorityDoHalf) {
    // A wheel that has locked at 20 m/s: after the first dump of pressure the torque is between that of none and all.
    const auto torqueAfter = [](bool enabled, double offset) {
        BrakeParams p = params();
        p.anti_lock.enabled = enabled;
        p.anti_lock.authority_offset = offset;
        const PerWheel<double> speed{20, 20, 20, 20}, locked{};
        BrakeState state;
        BrakeTorques torques{};
        for (int k = 0; k < 50; ++k) {
            const BrakeInput in{.pedal_begin = 1, .pedal_end = 1, .speed = speed, .rolling = locked};
            torques = advance(state, p, in, kStep);
        }
        return torques.end.front_left;
    };
    const double none = torqueAfter(false, 0), all = torqueAfter(true, 0);
    EXPECT_LT(all, 0.9 * none);
    EXPECT_EQ(torqueAfter(false, 1), all);
    EXPECT_EQ(torqueAfter(true, -1), none);
    EXPECT_NEAR(torqueAfter(false, 0.5), 0.5 * (none + all), 1e-9);
}

}  // namespace
}  // namespace tread::brakes_test
