#include "tread/engine.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tread::engine_test {
namespace {

EngineParams engine() {
    EngineParams e;
    e.full_load = {{{80, 100}, {300, 150}, {600, 120}, {700, 90}}};
    e.drag = {{{0, 12}, {700, 40}}};
    e.inertia = 0.15;
    e.idle_speed = 80;
    e.speed_limit = 680;
    return e;
}

// ---- Combustion engine ----

TEST(Engine, GivesFullLoadDragAndBetweenThemALinearTorque) {
    const EngineParams e = engine();
    for (const double speed : {200.0, 450.0, 620.0}) {
        EXPECT_DOUBLE_EQ(engineTorque(e, 1, speed), e.full_load(speed));
        EXPECT_DOUBLE_EQ(engineTorque(e, 0, speed), -e.drag(speed));
        EXPECT_NEAR(engineTorque(e, 0.3, speed), 0.3 * e.full_load(speed) - 0.7 * e.drag(speed), 1e-9);
    }
}

TEST(Engine, ScalesTorqueAndDragByThemselves) {
    EngineParams e = engine();
    e.torque_scale = 0.9;
    e.drag_scale = 1.5;
    EXPECT_DOUBLE_EQ(engineTorque(e, 1, 300), 0.9 * engine().full_load(300));
    EXPECT_DOUBLE_EQ(engineTorque(e, 0, 300), -1.5 * engine().drag(300));
    EXPECT_DOUBLE_EQ(engineTorque(e, 1, 690), -1.5 * engine().drag(690)) << "beyond the speed limit";
    EXPECT_NEAR(throttleFor(e, engineTorque(e, 0.4, 300), 300), 0.4, 1e-12);
}

TEST(Engine, IdlesWithoutTorqueAtIdleSpeedAndWithoutAJumpBesideIt) {
    const EngineParams e = engine();
    EXPECT_EQ(engineTorque(e, 0, e.idle_speed), 0);
    double before = engineTorque(e, 0, 40);
    for (double speed = 40; speed < 120; speed += 0.01) {
        const double torque = engineTorque(e, 0, speed);
        EXPECT_LE(torque, before + 1e-9) << "falls with speed: a stable equilibrium";
        EXPECT_LT(before - torque, 0.05);
        before = torque;
    }
}

TEST(Engine, MapThatIsLinearIsTheModelWithoutAMap) {
    const EngineParams plain = engine();
    EngineParams mapped = plain;
    for (const double t : {0.25, 0.5, 0.75}) {
        Curve torque;
        for (double speed = 50; speed <= 700; speed += 2.5)
            torque.points.push_back({speed, t * plain.full_load(speed) - (1 - t) * plain.drag(speed)});
        mapped.part_load.push_back({t, torque});
    }
    for (double speed = 100; speed < 680; speed += 13) {
        for (const double t : {0.0, 0.1, 0.25, 0.4, 0.9, 1.0})
            EXPECT_NEAR(engineTorque(mapped, t, speed), engineTorque(plain, t, speed), 0.02);
    }
}

TEST(Engine, MapGivesItsRowsAndIsLinearBetweenThem) {
    EngineParams e = engine();
    e.part_load = {{0.2, {{{0, 80}, {700, 20}}}}, {0.6, {{{0, 110}, {700, 70}}}}};
    const double at = 350;
    EXPECT_DOUBLE_EQ(engineTorque(e, 0.2, at), 50);
    EXPECT_DOUBLE_EQ(engineTorque(e, 0.6, at), 90);
    EXPECT_DOUBLE_EQ(engineTorque(e, 0.4, at), 70);
    EXPECT_DOUBLE_EQ(engineTorque(e, 0.8, at), 0.5 * (90 + e.full_load(at)));
    EXPECT_DOUBLE_EQ(engineTorque(e, 0.1, at), 0.5 * (50 - e.drag(at)));
}

TEST(Engine, ThrottleForATorqueIsTheInverseOfTheMap) {
    EngineParams e = engine();
    for (const bool mapped : {false, true}) {
        if (mapped) e.part_load = {{0.2, {{{0, 80}, {700, 20}}}}, {0.6, {{{0, 110}, {700, 70}}}}};
        for (const double t : {0.05, 0.2, 0.37, 0.6, 0.95})
            EXPECT_NEAR(throttleFor(e, engineTorque(e, t, 320), 320), t, 1e-12);
        EXPECT_GT(throttleFor(e, e.full_load(320) + 10, 320), 1);
        EXPECT_LT(throttleFor(e, -e.drag(320) - 10, 320), 0);
        EXPECT_EQ(throttleFor(e, 0, e.idle_speed), 0) << "the idle control idles it";
    }
}

// ---- Electric motor ----

MotorParams motor() {
    return {.torque = 200,
            .power = 60000,
            .speed_limit = 1200,
            .inertia = 0.05,
            .drag = {{{0, 1}, {1200, 5}}},
            .lift_off_regeneration = 0.3,
            .brake_regeneration = 1};
}

TEST(Motor, GivesItsTorqueThenItsPowerThenNothing) {
    MotorParams m = motor();
    m.drag = {};
    EXPECT_DOUBLE_EQ(motorTorque(m, 1, 0, 0).total, 200);
    EXPECT_DOUBLE_EQ(motorTorque(m, 1, 0, 250).total, 200);
    for (const double speed : {400.0, 800.0}) EXPECT_DOUBLE_EQ(motorTorque(m, 1, 0, speed).total * speed, 60000);
    EXPECT_DOUBLE_EQ(motorTorque(m, 1, 0, 1200).total, 0);
}

TEST(Motor, WithoutCurrentControlItsTorqueFallsToNoneAtTheSpeedWithoutLoad) {
    MotorParams m = motor();
    m.drag = {};
    m.no_load_speed = 1000;
    for (const double speed : {0.0, 100.0, 1000.0})
        EXPECT_NEAR(motorTorque(m, 1, 0, speed).total, 200 * (1 - speed / 1000), 1e-12);
    EXPECT_EQ(motorTorque(m, 1, 0, 1100).total, 0) << "beyond, it does not brake";
    EXPECT_DOUBLE_EQ(motorTorque(m, 1, 0, -100).total, 200) << "backwards, its largest torque is the limit";
    m.power = 20000;
    EXPECT_DOUBLE_EQ(motorTorque(m, 1, 0, 500).total, 40) << "and so is its power";
}

TEST(Motor, DoesNotDriveWithinItsDeadBand) {
    MotorParams m = motor();
    m.throttle_dead_band = 0.2;
    m.lift_off_regeneration = 0;
    m.drag = {};
    EXPECT_EQ(motorTorque(m, 0.2, 0, 100).total, 0);
    EXPECT_DOUBLE_EQ(motorTorque(m, 0.6, 0, 100).total, 100);
    EXPECT_DOUBLE_EQ(motorTorque(m, 1, 0, 100).total, 200);
}

TEST(Motor, RecoversAtClosedThrottleAndNotAtStandstill) {
    const MotorParams m = motor();
    EXPECT_NEAR(motorTorque(m, 0, 0, 250).total, -0.3 * 200 - m.drag(250), 1e-12);
    EXPECT_NEAR(motorTorque(m, 0, 0, 15).total, 0.5 * (-0.3 * 200 - m.drag(15)), 1e-12);
    EXPECT_EQ(motorTorque(m, 0, 0, 0).total, 0);
    EXPECT_EQ(motorTorque(m, 0, 50, 0).for_brake, 0);
}

TEST(Motor, TakesOverFromTheBrakeAsFarAsItCan) {
    const MotorParams m = motor();
    const MotorTorque some = motorTorque(m, 0, 50, 250);
    EXPECT_DOUBLE_EQ(some.for_brake, 50);
    EXPECT_NEAR(some.total, -60 - 50 - m.drag(250), 1e-12);
    const MotorTorque most = motorTorque(m, 0, 1000, 250);
    EXPECT_DOUBLE_EQ(most.for_brake, 200 - 60) << "what it recovers at lift-off counts too";
}

TEST(Motor, ThrottleForATorqueIsTheInverse) {
    const MotorParams m = motor();
    for (const double speed : {5.0, 200.0, 700.0}) {
        for (const double t : {0.0, 0.4, 1.0})
            EXPECT_NEAR(throttleFor(m, motorTorque(m, t, 0, speed).total, speed), t, 1e-12);
    }
    MotorParams voltage = m;
    voltage.no_load_speed = 1000;
    voltage.throttle_dead_band = 0.2;
    for (const double t : {0.3, 1.0})
        EXPECT_NEAR(throttleFor(voltage, motorTorque(voltage, t, 0, 700).total, 700), t, 1e-12);
}

}  // namespace
}  // namespace tread::engine_test
