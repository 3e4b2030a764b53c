// Four wheels on a bench: the driveline shares its torque, the test's own equations turn the wheels.

#include "tread/differential.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tread/driveline.h"

namespace tread::differential_test {
namespace {

constexpr double kStep = 0.001;   // s
constexpr double kInertia = 1.1;  // kg m2, of each wheel

DrivelineParams params() {
    DrivelineParams p;
    p.motor = MotorParams{.torque = 200, .power = 1e9, .speed_limit = 1e4, .inertia = 0.05, .drag = {}};
    p.gearbox = {.ratios = {1}, .final_drive = 8, .efficiency = 1, .inertia = 0.01};
    p.front_share = 1;
    return p;
}

struct Bench {
    explicit Bench(const DrivelineParams& p, double start) : params(p), spin{start, start, start, start} {
        state = steadyDriveline(p, start, 0).state;
    }

    // One step; `road` is the torque of the road on each wheel.
    DrivelineTorques step(double throttle, const PerWheel<double>& road) {
        DrivelineInput in{.throttle = throttle, .clutch_pedal = 0, .wheel_spin = spin};
        in.wheel_load = load;
        in.wheel_inertia = {kInertia, kInertia, kInertia, kInertia};
        in.lateral_acceleration = lateral_acceleration;
        const DrivelineTorques out = advance(state, params, in, kStep);
        for (std::size_t i = 0; i < kWheels; ++i) spin[i] += kStep * (out.wheel[i] + road[i]) / kInertia;
        load = road;
        return out;
    }

    DrivelineParams params;
    DrivelineState state;
    PerWheel<double> spin;
    PerWheel<double> load{};
    double lateral_acceleration = 0;
};

// A road like a tyre's: its torque grows with the slip of the wheel against a car at `speed`.
PerWheel<double> road(const PerWheel<double>& spin, const PerWheel<double>& speed, double grip) {
    PerWheel<double> torque;
    for (std::size_t i = 0; i < kWheels; ++i) torque[i] = -grip * (spin[i] - speed[i]);
    return torque;
}

TEST(Differential, LockedAxleTurnsBothWheelsAlike) {
    DrivelineParams p = params();
    p.front_differential = LockedDifferential{};
    Bench bench(p, 30);
    // One wheel on ice, one on grip; in a turn; under changing torque.
    for (int k = 0; k < 3000; ++k) {
        const double t = k * kStep;
        const PerWheel<double> speed{29, 31, 30, 30};
        PerWheel<double> torque = road(bench.spin, speed, 120);
        torque.front_left *= 0.05;
        bench.step(0.5 + 0.4 * std::sin(9 * t), torque);
        if (k > 20) {
            EXPECT_NEAR(bench.spin.front_left, bench.spin.front_right, 0.02) << t;
        }
    }
}

TEST(Differential, LockedAxleDoesNotTwistApartOverTime) {
    DrivelineParams p = params();
    p.front_differential = LockedDifferential{};
    Bench bench(p, 30);
    double twist = 0;
    for (int k = 0; k < 20000; ++k) {
        PerWheel<double> torque = road(bench.spin, {29, 31, 30, 30}, 120);
        torque.front_left += 80 * std::sin(40 * k * kStep);
        bench.step(0.3, torque);
        twist += kStep * (bench.spin.front_left - bench.spin.front_right);
    }
    EXPECT_LT(std::abs(twist), 1e-3) << "rad after 20 s: the errors of the steps cancel";
}

TEST(Differential, WhatItMovesConservesAngularMomentumAndTakesEnergy) {
    for (const AxleDifferential& d :
         {AxleDifferential(LockedDifferential{}), AxleDifferential(LimitedSlipDifferential{.preload = 60})}) {
        DrivelineParams p = params();
        p.front_differential = d;
        Bench bench(p, 0);
        bench.spin = {20, 40, 30, 30};
        for (int k = 0; k < 200; ++k) {
            const double before = bench.spin.front_left + bench.spin.front_right;
            const double energy = std::hypot(bench.spin.front_left, bench.spin.front_right);
            const PerWheel<double> spin = bench.spin;
            const DrivelineTorques out = bench.step(0, {});
            const double shaft = out.wheel.front_left + out.wheel.front_right;
            EXPECT_NEAR(bench.spin.front_left + bench.spin.front_right, before + kStep * shaft / kInertia, 1e-9);
            // Without the shaft's half to each wheel.
            const double moved = 0.5 * (out.wheel.front_right - out.wheel.front_left);
            EXPECT_LE(moved * (spin.front_right - spin.front_left), 1e-9) << "from the faster to the slower";
            (void)energy;
        }
        EXPECT_NEAR(bench.spin.front_left, bench.spin.front_right, 12);
    }
}

TEST(Differential, LimitedSlipHoldsItsPreloadThenSlips) {
    DrivelineParams p = params();
    p.front_differential = LimitedSlipDifferential{.preload = 80};
    for (const double difference : {60.0, 100.0}) {
        Bench bench(p, 30);
        DrivelineTorques out{};
        for (int k = 0; k < 400; ++k) out = bench.step(0, {0.5 * difference, -0.5 * difference, 0, 0});
        EXPECT_NEAR(out.wheel.front_right - out.wheel.front_left, std::min(difference, 80.0), 1e-6);
        if (difference < 80) EXPECT_NEAR(bench.spin.front_left, bench.spin.front_right, 0.1);
        else EXPECT_NEAR(bench.spin.front_left - bench.spin.front_right, 0.4 * (difference - 80) / kInertia, 0.3);
    }
}

TEST(Differential, TorqueSensingKeepsTheTorqueBiasRatio) {
    // One wheel has no grip at all: the other gets at most the bias ratio times what that one takes.
    const double bias = 3;
    DrivelineParams p = params();
    p.front_differential = LimitedSlipDifferential{.locking_driving = (bias - 1) / (bias + 1)};
    Bench bench(p, 30);
    DrivelineTorques out{};
    for (int k = 0; k < 300; ++k) {
        PerWheel<double> torque = road(bench.spin, {30, 30, 30, 30}, 200);
        torque.front_left = -5;
        out = bench.step(0.4, torque);
    }
    EXPECT_GT(bench.spin.front_left, bench.spin.front_right + 1) << "spins";
    EXPECT_NEAR(out.wheel.front_right / out.wheel.front_left, bias, 1e-6);
}

TEST(Differential, FrictionOfAnOpenOneKeepsItsTorqueBiasRatio) {
    const double bias = 1.2;
    DrivelineParams p = params();
    p.front_differential = OpenDifferential{.locking = (bias - 1) / (bias + 1)};
    Bench bench(p, 30);
    DrivelineTorques out{};
    for (int k = 0; k < 300; ++k) {
        PerWheel<double> torque = road(bench.spin, {30, 30, 30, 30}, 200);
        torque.front_left = -5;
        out = bench.step(0.4, torque);
    }
    EXPECT_NEAR(out.wheel.front_right / out.wheel.front_left, bias, 1e-6);
}

TEST(Differential, LockingOnOverrunIsItsOwn) {
    DrivelineParams p = params();
    p.motor->lift_off_regeneration = 0.5;
    p.front_differential = LimitedSlipDifferential{.locking_driving = 0, .locking_coasting = 0.4};
    Bench bench(p, 60);
    bench.spin = {55, 65, 60, 60};
    const auto difference = [&](double throttle) {
        DrivelineTorques out{};
        Bench copy = bench;
        for (int k = 0; k < 50; ++k) {
            copy.spin = bench.spin;
            out = copy.step(throttle, {});
        }
        return std::abs(out.wheel.front_right - out.wheel.front_left) /
               std::abs(out.wheel.front_right + out.wheel.front_left);
    };
    EXPECT_NEAR(difference(0.8), 0, 1e-9);
    EXPECT_NEAR(difference(0), 0.4, 1e-6);
}

TEST(Differential, ViscousCouplingFollowsTheDifferenceOfSpeeds) {
    DrivelineParams p = params();
    p.front_differential = LimitedSlipDifferential{.viscosity = 20};
    Bench bench(p, 0);
    bench.spin = {40, 20, 30, 30};
    // Free wheels come together exponentially: I d(slip)/dt = -2 (viscosity / 2) slip.
    for (int k = 1; k <= 60; ++k) {
        bench.step(0, {});
        EXPECT_NEAR(bench.spin.front_left - bench.spin.front_right, 20 * std::exp(-20 / kInertia * k * kStep), 0.25);
    }
}

TEST(Differential, CentreCouplingBringsTheOtherAxleAlong) {
    DrivelineParams p = params();
    p.centre_differential = LimitedSlipDifferential{.preload = 600};
    Bench bench(p, 30);
    // The driven axle stands on ice, the other on grip.
    DrivelineTorques out{};
    for (int k = 0; k < 500; ++k) {
        PerWheel<double> torque = road(bench.spin, {30, 30, 30, 30}, 300);
        torque.front_left = torque.front_right = 0;
        out = bench.step(0.5, torque);
    }
    EXPECT_NEAR(out.wheel.rear_left + out.wheel.rear_right, 300, 1e-6) << "half the difference of torques";
    p.centre_differential = LockedDifferential{};
    Bench locked(p, 30);
    for (int k = 0; k < 500; ++k) {
        PerWheel<double> torque = road(locked.spin, {30, 30, 30, 30}, 300);
        torque.front_left = torque.front_right = 0;
        out = locked.step(0.5, torque);
    }
    EXPECT_NEAR(locked.spin.front_left, locked.spin.rear_left, 0.01);
    EXPECT_GT(out.wheel.rear_left, 5 * std::abs(out.wheel.front_left));
}

TEST(Differential, VectoringMovesTorqueToTheOuterWheel) {
    DrivelineParams p = params();
    p.front_differential = VectoringDifferential{.by_lateral_acceleration = 50, .largest = 300};
    Bench bench(p, 30);
    bench.lateral_acceleration = 4;
    DrivelineTorques out = bench.step(0.3, {});
    EXPECT_NEAR(out.wheel.front_right - out.wheel.front_left, 200, 1e-9) << "turning left, the right wheel is outer";
    bench.lateral_acceleration = -20;
    out = bench.step(0.3, {});
    EXPECT_NEAR(out.wheel.front_right - out.wheel.front_left, -300, 1e-9);
}

TEST(Differential, HeldWheelsOfALockedAxleStayCalm) {
    // Both brakes hold: what goes through the axle cannot be told, but it must not grow.
    DrivelineParams p = params();
    p.front_differential = LockedDifferential{};
    Bench bench(p, 0);
    double largest = 0;
    for (int k = 0; k < 5000; ++k) {
        DrivelineInput in{.throttle = 0.2, .clutch_pedal = 0, .wheel_spin = {}};
        in.wheel_load = bench.load;
        in.wheel_inertia = {kInertia, kInertia, kInertia, kInertia};
        const DrivelineTorques out = advance(bench.state, p, in, kStep);
        for (std::size_t i = 0; i < kWheels; ++i) bench.load[i] = -out.wheel[i];
        largest = std::max(largest, std::abs(out.wheel.front_left - out.wheel.front_right));
    }
    EXPECT_LT(largest, 1e-6);
}

}  // namespace
}  // namespace tread::differential_test
