#include "tread/driveline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::driveline_test {
namespace {

constexpr double kStep = 0.001;  // s

DrivelineParams params() {
    DrivelineParams p;
    p.engine.emplace();
    p.engine->full_load = {{{80, 100}, {300, 150}, {600, 120}, {700, 90}}};
    p.engine->drag = {{{0, 12}, {700, 40}}};
    p.engine->inertia = 0.15;
    p.engine->idle_speed = 80;
    p.engine->speed_limit = 680;
    p.coupling = ClutchParams{250};
    p.gearbox = {.ratios = {3.5, 2.0, 1.3, 1.0},
                 .final_drive = 4,
                 .efficiency = 0.94,
                 .inertia = 0.01,
                 .shift_up_speed = 620,
                 .shift_down_speed = 140};
    p.front_share = 1;
    return p;
}

PerWheel<double> all(double spin) {
    return {spin, spin, spin, spin};
}

double totalTorque(const DrivelineTorques& t) {
    return t.wheel.front_left + t.wheel.front_right + t.wheel.rear_left + t.wheel.rear_right;
}

double ratioOf(const DrivelineParams& p, int gear) {
    return p.gearbox.ratios[static_cast<std::size_t>(gear - 1)] * p.gearbox.final_drive;
}

// ---- Steady running ----

TEST(Driveline, SteadyStateStaysAndGivesTheTorqueThatWasAskedFor) {
    const DrivelineParams p = params();
    for (const double spin : {40.0, 90.0}) {
        for (const double torque : {-60.0, 0.0, 250.0}) {
            const SteadyDriveline steady = steadyDriveline(p, spin, torque);
            DrivelineState state = steady.state;
            DrivelineTorques out{};
            for (int k = 0; k < 500; ++k) out = advance(state, p, {steady.throttle, 0, all(spin)}, kStep);
            EXPECT_NEAR(totalTorque(out), torque, 1e-6);
            EXPECT_NEAR(state.engine_speed, steady.state.engine_speed, 1e-9);
            EXPECT_EQ(state.gear, steady.state.gear);
            EXPECT_NEAR(state.engine_speed, spin * ratioOf(p, state.gear), 1e-9) << "clutch closed";
        }
    }
}

TEST(Driveline, ThrottleOfSteadyRunningFollowsFromTheTorqueMap) {
    const DrivelineParams p = params();
    const SteadyDriveline steady = steadyDriveline(p, 90, 200);
    const double ratio = ratioOf(p, steady.state.gear);
    const double speed = 90 * ratio;
    const double engine = 200 / ratio / p.gearbox.efficiency;
    const double drag = p.engine->drag(speed);
    EXPECT_NEAR(steady.throttle, (engine + drag) / (p.engine->full_load(speed) + drag), 1e-12);
}

TEST(Driveline, OverrunTurnsTheEngineAgainstItsDragAndBrakesTheCar) {
    const DrivelineParams p = params();
    DrivelineState state = steadyDriveline(p, 90, 0).state;
    DrivelineTorques out{};
    for (int k = 0; k < 2000; ++k) out = advance(state, p, {0, 0, all(90)}, kStep);
    const double ratio = ratioOf(p, state.gear);
    EXPECT_NEAR(totalTorque(out), -p.engine->drag(90 * ratio) * ratio / p.gearbox.efficiency, 1e-3)
        << "the gearbox takes its loss from the wheels";
}

TEST(Driveline, FuelIsCutAtTheSpeedLimit) {
    DrivelineParams p = params();
    DrivelineState state{.engine_speed = 700};
    const DrivelineTorques out = advance(state, p, {1, 1, all(0)}, kStep);
    EXPECT_EQ(out.engine, -p.engine->drag(700));
    double highest = 0;
    state = {.engine_speed = 300};
    for (int k = 0; k < 5000; ++k) {
        advance(state, p, {1, 1, all(0)}, kStep);
        highest = std::max(highest, state.engine_speed);
    }
    EXPECT_LT(highest, p.engine->speed_limit + 2) << "full throttle, declutched";
    EXPECT_GT(state.engine_speed, p.engine->speed_limit - 2);
}

// ---- Standing ----

TEST(Driveline, EngineIdlesAtStandstillAndLeavesTheWheelsAlone) {
    const DrivelineParams p = params();
    for (const double start : {60.0, 80.0, 120.0}) {
        DrivelineState state = steadyDriveline(p, 0, 0).state;
        state.engine_speed = start;
        DrivelineTorques out{};
        for (int k = 0; k < 20000; ++k) out = advance(state, p, {0, 0, all(0)}, kStep);
        EXPECT_NEAR(state.engine_speed, p.engine->idle_speed, 0.01 * p.engine->idle_speed) << "from " << start;
        EXPECT_NEAR(totalTorque(out), 0, 1e-6);
        EXPECT_EQ(state.gear, 1);
    }
}

TEST(Driveline, OpenClutchLetsTheEngineRevAlone) {
    const DrivelineParams p = params();
    DrivelineState state = steadyDriveline(p, 30, 0).state;
    DrivelineTorques out{};
    for (int k = 0; k < 1000; ++k) out = advance(state, p, {0.5, 1, all(30)}, kStep);
    EXPECT_GT(state.engine_speed, 500);
    EXPECT_NEAR(totalTorque(out), 0, 1e-6);
}

TEST(Driveline, ThrottleAtStandstillPushesForwardWithTheTorqueOfTheClutch) {
    const DrivelineParams p = params();
    DrivelineState state = steadyDriveline(p, 0, 0).state;
    DrivelineTorques out{};
    for (int k = 0; k < 3000; ++k) out = advance(state, p, {0.5, 0, all(0)}, kStep);
    // Held wheels: the engine settles where the slipping clutch takes its torque.
    EXPECT_NEAR(totalTorque(out), out.engine * ratioOf(p, 1) * p.gearbox.efficiency, 1);
    EXPECT_GT(totalTorque(out), 500);
    EXPECT_GT(state.engine_speed, p.engine->idle_speed);
}

// ---- Clutch ----

TEST(Driveline, ClutchLocksAndStaysLocked) {
    const DrivelineParams p = params();
    for (const double engine_speed : {200.0, 600.0}) {
        DrivelineState state = steadyDriveline(p, 90, 0).state;
        const double locked = state.gearbox_speed;
        state.engine_speed = engine_speed;
        bool was_locked = false;
        double torque = 0, changes = 0;
        for (int k = 0; k < 3000; ++k) {
            const double before = torque;
            torque = totalTorque(advance(state, p, {0.3, 0, all(90)}, kStep));
            const bool is_locked = std::abs(state.engine_speed - state.gearbox_speed) < 1e-9;
            if (was_locked) {
                EXPECT_TRUE(is_locked) << "slips again after " << k << " steps";
            }
            was_locked = is_locked;
            if (k >= 2000) changes = std::max(changes, std::abs(torque - before));
        }
        EXPECT_TRUE(was_locked);
        EXPECT_NEAR(state.engine_speed, locked, 0.5);
        EXPECT_LT(changes, 0.05) << "N m from step to step: no chatter";
    }
}

TEST(Driveline, SlippingClutchCarriesItsCapacity) {
    DrivelineParams p = params();
    p.gearbox.efficiency = 1;
    DrivelineState state = steadyDriveline(p, 0, 0).state;
    state.engine_speed = 500;
    DrivelineTorques out{};
    for (int k = 0; k < 150; ++k) out = advance(state, p, {1, 0, all(0)}, kStep);
    EXPECT_GT(state.engine_speed, 1.5 * p.engine->idle_speed) << "closed by speed, but the engine still turns faster";
    double mean = 0;
    for (int k = 0; k < 100; ++k) mean += totalTorque(advance(state, p, {1, 0, all(0)}, kStep)) / 100;
    EXPECT_NEAR(mean, std::get<ClutchParams>(p.coupling).torque * ratioOf(p, 1),
                0.05 * std::get<ClutchParams>(p.coupling).torque * ratioOf(p, 1));
}

// ---- Gears ----

// Wheel spin at which the gearbox takes the next gear while it speeds up slowly.
double shiftUpAt(const DrivelineParams& p, double throttle) {
    DrivelineState state = steadyDriveline(p, 5, 0).state;
    const int gear = state.gear;
    for (double spin = 5; spin < 200; spin += 0.002) {
        advance(state, p, {throttle, 0, all(spin)}, kStep);
        if (state.gear != gear) return spin;
    }
    return 0;
}

TEST(Driveline, ShiftsUpAtTheShiftSpeedOfTheThrottle) {
    const DrivelineParams p = params();
    EXPECT_NEAR(shiftUpAt(p, 1) * ratioOf(p, 1), p.gearbox.shift_up_speed, 2);
    EXPECT_NEAR(shiftUpAt(p, 0.5) * ratioOf(p, 1), 0.725 * p.gearbox.shift_up_speed, 2);
    EXPECT_NEAR(shiftUpAt(p, 0) * ratioOf(p, 1), 0.45 * p.gearbox.shift_up_speed, 2);
}

TEST(Driveline, ShiftsDownBelowTheShiftDownSpeedGearByGear) {
    const DrivelineParams p = params();
    DrivelineState state = steadyDriveline(p, 110, 0).state;
    ASSERT_EQ(state.gear, 4);
    int gear = 4;
    for (double spin = 110; spin > 3; spin -= 0.005) {
        advance(state, p, {0, 0, all(spin)}, kStep);
        if (state.gear == gear) continue;
        EXPECT_EQ(state.gear, gear - 1);
        EXPECT_NEAR(spin * ratioOf(p, gear), p.gearbox.shift_down_speed, 3);
        gear = state.gear;
    }
    EXPECT_EQ(gear, 1);
}

TEST(Driveline, DoesNotHuntBetweenGears) {
    const DrivelineParams p = params();
    for (double spin = 5; spin < 150; spin += 0.5) {
        for (const double throttle : {0.0, 0.3, 1.0}) {
            DrivelineState state = steadyDriveline(p, spin, 0).state;
            int shifts = 0;
            for (int k = 0; k < 4000; ++k) {
                const int before = state.gear;
                advance(state, p, {throttle, 0, all(spin)}, 0.002);
                shifts += state.gear != before;
            }
            EXPECT_LE(shifts, 3) << "at " << spin << " rad/s, throttle " << throttle;
        }
    }
}

// ---- Differentials ----

TEST(Driveline, OpenDifferentialGivesBothWheelsTheSameTorqueAndFollowsTheirMeanSpeed) {
    DrivelineParams p = params();
    const auto torqueAt = [&](const PerWheel<double>& spin) {
        DrivelineState state = steadyDriveline(p, 50, 100).state;
        DrivelineTorques out{};
        for (int k = 0; k < 200; ++k) out = advance(state, p, {0.3, 0, spin}, kStep);
        return out;
    };
    const DrivelineTorques straight = torqueAt({50, 50, 0, 0}), turning = torqueAt({45, 55, 0, 0});
    EXPECT_DOUBLE_EQ(straight.wheel.front_left, turning.wheel.front_left);
    EXPECT_EQ(straight.wheel.rear_left, 0) << "front drive";
    p.front_share = 0;
    EXPECT_EQ(torqueAt({0, 0, 45, 55}).wheel.front_left, 0) << "rear drive";
}

TEST(Driveline, SharedDriveConservesPower) {
    for (const double front_share : {0.0, 0.35, 1.0}) {
        DrivelineParams p = params();
        p.gearbox.efficiency = 1;
        p.front_share = front_share;
        const PerWheel<double> spin{60, 64, 50, 58};
        const double mean = front_share * 62 + (1 - front_share) * 54;
        DrivelineState state = steadyDriveline(p, mean, 150).state;
        const double throttle = steadyDriveline(p, mean, 150).throttle;
        DrivelineTorques out{};
        for (int k = 0; k < 2000; ++k) out = advance(state, p, {throttle, 0, spin}, kStep);
        const double wheels = out.wheel.front_left * (60 + 64) + out.wheel.rear_left * (50 + 58);
        EXPECT_NEAR(wheels, out.engine * state.engine_speed, 1e-6 * wheels) << front_share;
        EXPECT_NEAR(2 * out.wheel.front_left, front_share * totalTorque(out), 1e-9);
    }
}

// ---- Energy ----

TEST(Driveline, EngineWorkGoesIntoTheWheelsTheRotatingPartsAndTheShaftDamping) {
    // A wheel set as heavy as a car hangs on the shafts; the clutch is locked all the time.
    DrivelineParams p = params();
    p.gearbox.efficiency = 1;
    const double inertia = 120;  // kg m2
    double spin = 50;
    DrivelineState state = steadyDriveline(p, spin, 0).state;
    const auto energy = [&] {
        return 0.5 * p.engine->inertia * state.engine_speed * state.engine_speed +
               0.5 * p.gearbox.inertia * state.gearbox_speed * state.gearbox_speed +
               0.5 * p.shaft_stiffness * state.twist * state.twist;
    };
    const double before = energy();
    double engine = 0, wheels = 0, damping = 0;
    for (int k = 0; k < 3000; ++k) {
        const double speed = state.engine_speed, gearbox = state.gearbox_speed, wheel = spin;
        const DrivelineTorques out = advance(state, p, {0.6, 0, all(spin)}, kStep);
        spin += kStep * totalTorque(out) / inertia;
        engine += kStep * out.engine * 0.5 * (speed + state.engine_speed);
        wheels += kStep * totalTorque(out) * 0.5 * (wheel + spin);
        const double rate = 0.5 * (gearbox + state.gearbox_speed) / ratioOf(p, state.gear) - wheel;
        damping += kStep * p.shaft_damping * rate * rate;
    }
    EXPECT_GT(engine, 10000);
    EXPECT_NEAR(engine, wheels + damping + energy() - before, 1e-3 * engine);
}

TEST(Driveline, EfficiencyTakesItsShareOfTheEnginePower) {
    const DrivelineParams p = params();
    const SteadyDriveline steady = steadyDriveline(p, 80, 300);
    DrivelineState state = steady.state;
    DrivelineTorques out{};
    for (int k = 0; k < 100; ++k) out = advance(state, p, {steady.throttle, 0, all(80)}, kStep);
    EXPECT_NEAR(totalTorque(out) * 80 / (out.engine * state.engine_speed), p.gearbox.efficiency, 1e-9);
}

TEST(Driveline, LightGearboxOnStiffShaftsIsStable) {
    DrivelineParams p = params();
    p.gearbox.inertia = 1e-6;
    p.shaft_stiffness = 1e6;
    p.shaft_damping = 1;
    DrivelineState state = steadyDriveline(p, 80, 0).state;
    DrivelineTorques out{};
    for (int k = 0; k < 2000; ++k) out = advance(state, p, {0.5, k < 1000 ? 0.0 : 1.0, all(80)}, 0.002);
    EXPECT_LT(std::abs(totalTorque(out)), 10) << "declutched at the end";
    EXPECT_TRUE(std::isfinite(state.engine_speed));
}

// ---- Shift time ----

TEST(Driveline, ShiftTimeLeavesAGapInTheTorque) {
    DrivelineParams p = params();
    p.gearbox.shift_time = 0.4;
    DrivelineState state = steadyDriveline(p, 30, 0).state;
    ASSERT_EQ(state.gear, 2);
    state.engine_speed = state.gearbox_speed = 1.01 * p.gearbox.shift_up_speed;
    const double spin = state.gearbox_speed / ratioOf(p, 2);
    DrivelineTorques out{};
    for (int k = 1; k <= 2000; ++k) {
        out = advance(state, p, {1, 0, all(spin)}, kStep);
        const double t = k * kStep;
        if (t > 0.15 && t < 0.26) {
            EXPECT_NEAR(totalTorque(out), 0, 20) << "open at " << t;
            EXPECT_LT(out.engine, 0) << "the foot is off the pedal";
        }
    }
    EXPECT_EQ(state.gear, 3);
    EXPECT_NEAR(totalTorque(out), p.engine->full_load(state.engine_speed) * ratioOf(p, 3) * p.gearbox.efficiency, 1);
}

TEST(Driveline, ShiftMapFollowsItsShares) {
    DrivelineParams p = params();
    p.gearbox.shift_up_share = {{{0, 0.3}, {0.5, 0.6}, {1, 0.9}}};
    EXPECT_NEAR(shiftUpAt(p, 0.5) * ratioOf(p, 1), 0.6 * p.gearbox.shift_up_speed, 2);
    EXPECT_NEAR(shiftUpAt(p, 1) * ratioOf(p, 1), 0.9 * p.gearbox.shift_up_speed, 2);
    // Kick-down: the pedal alone takes the gear below.
    p.gearbox.shift_down_share = {{{0.8, 1}, {0.9, 2.2}}};
    DrivelineState state = steadyDriveline(p, 60, 0).state;
    const int gear = state.gear;
    for (int k = 0; k < 100; ++k) advance(state, p, {0.5, 0, all(60)}, kStep);
    EXPECT_EQ(state.gear, gear);
    for (int k = 0; k < 100; ++k) advance(state, p, {1, 0, all(60)}, kStep);
    EXPECT_EQ(state.gear, gear - 1);
}

// ---- Lag ----

TEST(Driveline, TorqueFollowsThePedalWithItsTimeConstant) {
    DrivelineParams p = params();
    p.engine->response_time = 0.12;
    DrivelineState state = steadyDriveline(p, 60, 0).state;
    const double start = state.engine_throttle, speed = state.engine_speed;
    for (int k = 1; k <= 150; ++k) {
        const DrivelineTorques out = advance(state, p, {0.8, 0, all(60)}, kStep);
        const double throttle = 0.8 + (start - 0.8) * std::exp(-k * kStep / 0.12);
        EXPECT_NEAR(state.engine_throttle, throttle, 1e-12);
        EXPECT_NEAR(out.engine, engineTorque(*p.engine, throttle, speed), 3);
    }
}

// ---- Torque converter ----

DrivelineParams withConverter() {
    DrivelineParams p = params();
    p.coupling = TorqueConverterParams{.capacity = {{{0, 0.0030}, {0.6, 0.0028}, {0.85, 0.0018}, {1, 0}}},
                                       .torque_ratio = {{{0, 2.1}, {0.85, 1}}}};
    return p;
}

TEST(Driveline, ConverterStallsWhereItTakesTheEnginesTorque) {
    const DrivelineParams p = withConverter();
    DrivelineState state = steadyDriveline(p, 0, 0).state;
    DrivelineTorques out{};
    for (int k = 0; k < 5000; ++k) out = advance(state, p, {1, 0, all(0)}, kStep);
    const double stall = state.engine_speed;
    EXPECT_NEAR(0.0030 * stall * stall, p.engine->full_load(stall), 1e-3);
    EXPECT_NEAR(totalTorque(out), 2.1 * p.engine->full_load(stall) * ratioOf(p, 1) * p.gearbox.efficiency, 1);
}

TEST(Driveline, ConverterCreepsAtIdleFromTheFirstStep) {
    const DrivelineParams p = withConverter();
    const SteadyDriveline steady = steadyDriveline(p, 0, 0);
    DrivelineState state = steady.state;
    const DrivelineTorques first = advance(state, p, {0, 0, all(0)}, kStep);
    DrivelineTorques out{};
    for (int k = 0; k < 3000; ++k) out = advance(state, p, {0, 0, all(0)}, kStep);
    EXPECT_GT(totalTorque(out), 300);
    EXPECT_NEAR(totalTorque(first), totalTorque(out), 0.1);
    EXPECT_NEAR(state.engine_speed, steady.state.engine_speed, 0.01);
}

TEST(Driveline, ConverterRunsSteadilyWhereAskedAndConservesWhatItDoesNotHeat) {
    const DrivelineParams p = withConverter();
    for (const double torque : {-80.0, 100.0, 500.0}) {
        const SteadyDriveline steady = steadyDriveline(p, 60, torque);
        DrivelineState state = steady.state;
        DrivelineTorques out{};
        for (int k = 0; k < 1000; ++k) out = advance(state, p, {steady.throttle, 0, all(60)}, kStep);
        EXPECT_NEAR(totalTorque(out), torque, 1) << "the steps of a stiff coupling move it a little";
        EXPECT_NEAR(state.engine_speed, steady.state.engine_speed, 0.5);
        const double engine = out.engine * state.engine_speed, wheels = totalTorque(out) * 60;
        EXPECT_GT(engine, wheels) << "heat";
    }
}

TEST(Driveline, LockedConverterDoesNotSlip) {
    DrivelineParams p = withConverter();
    auto& converter = std::get<TorqueConverterParams>(p.coupling);
    converter.lock_up_torque = 300;
    converter.lock_up_speed_ratio = 0.8;
    converter.lock_up_gear = 2;
    SteadyDriveline steady = steadyDriveline(p, 30, 300);
    DrivelineState state = steady.state;
    for (int k = 0; k < 1000; ++k) advance(state, p, {steady.throttle, 0, all(30)}, kStep);
    EXPECT_NEAR(state.engine_speed, state.gearbox_speed, 0.01);
    converter.lock_up_gear = 3;
    for (int k = 0; k < 1000; ++k) advance(state, p, {steady.throttle, 0, all(30)}, kStep);
    EXPECT_GT(state.engine_speed, state.gearbox_speed + 5);
}

TEST(Driveline, ConverterIsStableForAnyStep) {
    const DrivelineParams p = withConverter();
    for (const double step : {0.0005, 0.002, 0.01}) {
        DrivelineState state = steadyDriveline(p, 90, 0).state;
        double lowest = 1e9, highest = 0;
        for (int k = 0; k < 4 / step; ++k) {
            advance(state, p, {0.3, 0, all(90)}, step);
            if (k * step < 3) continue;
            lowest = std::min(lowest, state.engine_speed);
            highest = std::max(highest, state.engine_speed);
        }
        EXPECT_LT(highest - lowest, 0.01) << step;
    }
}

// ---- Electric motor ----

DrivelineParams electric() {
    DrivelineParams p = params();
    p.engine.reset();
    p.motor = MotorParams{.torque = 250,
                          .power = 1e5,
                          .speed_limit = 1500,
                          .inertia = 0.06,
                          .drag = {{{0, 1}, {1500, 4}}},
                          .lift_off_regeneration = 0.2,
                          .brake_regeneration = 0.6};
    p.gearbox = {.ratios = {1}, .final_drive = 9, .efficiency = 0.96, .inertia = 0.005};
    return p;
}

TEST(Driveline, MotorRunsSteadilyWhereAsked) {
    const DrivelineParams p = electric();
    for (const double torque : {-200.0, 0.0, 700.0}) {
        const SteadyDriveline steady = steadyDriveline(p, 70, torque);
        DrivelineState state = steady.state;
        DrivelineTorques out{};
        for (int k = 0; k < 500; ++k) out = advance(state, p, {steady.throttle, 0, all(70)}, kStep);
        EXPECT_NEAR(totalTorque(out), torque, 1e-6);
        EXPECT_NEAR(state.engine_speed, 70 * 9, 1e-9) << "what is logged as engine speed";
    }
}

TEST(Driveline, MotorBrakesForThePedalWhatItSaysItBrakes) {
    const DrivelineParams p = electric();
    SteadyDriveline steady = steadyDriveline(p, 70, 0);
    DrivelineState state = steady.state;
    DrivelineTorques lift{}, brake{};
    for (int k = 0; k < 3000; ++k) lift = advance(state, p, {0, 0, all(70)}, kStep);
    for (int k = 0; k < 3000; ++k)
        brake =
            advance(state, p, {.throttle = 0, .clutch_pedal = 0, .wheel_spin = all(70), .brake_torque = 900}, kStep);
    EXPECT_NEAR(2 * brake.braked.front, 0.6 * 900, 1e-9);
    EXPECT_NEAR(totalTorque(lift) - totalTorque(brake), 2 * (brake.braked.front + brake.braked.rear), 1e-3);
}

TEST(Driveline, EngineAndMotorTogetherRunSteadily) {
    DrivelineParams p = params();
    p.motor = MotorParams{.torque = 60, .power = 15000, .speed_limit = 800, .inertia = 0.02, .drag = {}};
    const SteadyDriveline steady = steadyDriveline(p, 60, 250);
    DrivelineState state = steady.state;
    DrivelineTorques out{};
    for (int k = 0; k < 500; ++k) out = advance(state, p, {steady.throttle, 0, all(60)}, kStep);
    EXPECT_NEAR(totalTorque(out), 250, 1e-6);
    EXPECT_GT(out.motor, 5);
}

}  // namespace
}  // namespace tread::driveline_test
