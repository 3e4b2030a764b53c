// A speed that is followed by a commanded force: closely, smoothly, from standstill to standstill, at any size of car.

#include "scenario/speed_follower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/fields/numbers.h"
#include "base/units/units.h"
#include "shared/vehicle_run.h"

namespace tread::speed_follower_test {
namespace {

using shared::channel;
using shared::valueAt;

constexpr double kClose = 0.05;  // m/s, root mean square

// Standing, off with 4 m/s2, a steady speed, braking with 6 m/s2 to standstill, off again with 2 m/s2.
const Curve kSteps{{{0, 0}, {1, 0}, {5, 16}, {7, 16}, {7 + 16 / 6.0, 0}, {13, 0}, {15, 4}, {16, 4}}};

Scenario following(const Curve& speed, double step = 0.004) {
    Scenario scenario;
    scenario.step = scenario.substep = step;
    scenario.start.speed = speed(0);
    Phase& phase = scenario.phases.emplace_back();
    phase.throttle = FollowSpeed{speed};
    phase.until.duration = speed.points.back().x;
    scenario.log.rate = 1 / step;
    return scenario;
}

double rmsError(const Log& log, const Curve& wanted) {
    const std::vector<double>&time = channel(log, "time"), &speed = channel(log, "chassis.vx");
    double sum = 0;
    for (std::size_t i = 0; i < time.size(); ++i) sum += std::pow(speed[i] - wanted(time[i]), 2);
    return std::sqrt(sum / static_cast<double>(time.size()));
}

// A car of a tenth of the length that rolls, pitches and slides as the whole one does, sqrt(10) times as fast.
VehicleParams tenth(VehicleParams car) {
    constexpr double kLength = 0.1, kMass = kLength * kLength * kLength;
    for (const Number& number : numbers(car)) {
        std::string fault;
        const auto unit = parseUnit(number.about.unit, fault);
        const auto& [length, mass, time, temperature, current, angle] = unit->dimension;
        *number.value *= std::pow(kLength, length + 0.5 * time) * std::pow(kMass, mass);
    }
    return car;
}

TEST(SpeedFollower, FollowsStepsOfAccelerationFromStandstillToStandstill) {
    for (const VehicleParams& car : {shared::compact(), shared::sedan()}) {
        for (const double step : {0.001, 0.004, 0.01})
            EXPECT_LT(rmsError(simulate(car, following(kSteps, step)), kSteps), kClose) << car.name << " " << step;
    }
}

TEST(SpeedFollower, FollowsWithACarOfATenthOfTheSize) {
    const Curve slower{{{0, 0}, {0.5, 0}, {2, 3}, {4, 3}, {5, 0}, {6, 0}}};
    EXPECT_LT(rmsError(simulate(tenth(shared::compact()), following(slower, 0.002)), slower), kClose);
}

TEST(SpeedFollower, NeitherTremblesInSteadyMotionNorAtStandstill) {
    const Log log = simulate(shared::compact(), following(kSteps));
    for (const auto& [from, to] : {std::pair{3.0, 4.9}, {6.0, 6.9}, {8.0, 9.4}, {12.0, 12.9}}) {
        double lowest = kInfinity, highest = -kInfinity;
        for (double t = from; t < to; t += 0.004) {
            lowest = std::min(lowest, valueAt(log, "chassis.ax", t));
            highest = std::max(highest, valueAt(log, "chassis.ax", t));
        }
        EXPECT_LT(highest - lowest, 0.1) << "m/s2 from " << from << " s on";
    }
    EXPECT_NEAR(valueAt(log, "chassis.x", 12.9), valueAt(log, "chassis.x", 12), 1e-3);
}

TEST(SpeedFollower, MotionIsSmoothInTheNumbersOfTheCar) {
    const auto with = [](double mass) {
        VehicleParams car = shared::compact();
        car.mass *= mass;
        car.aero.drag_area *= mass;
        return simulate(car, following(kSteps));
    };
    const Log none = with(1), half = with(1.005), whole = with(1.01);
    for (const char* name : {"wheel.front_left.fx", "wheel.rear_left.load", "chassis.pitch"}) {
        double bend = 0, slope = 0;
        for (const double t : {2.0, 4.0, 6.0, 8.0, 9.0, 14.0, 15.5}) {
            const double a = valueAt(none, name, t), b = valueAt(half, name, t), c = valueAt(whole, name, t);
            bend = std::max(bend, std::abs(a - 2 * b + c));
            slope = std::max(slope, std::abs(c - a));
        }
        EXPECT_LT(bend, 0.05 * slope) << name;
    }
}

TEST(SpeedFollower, WhatTheGripDoesNotGiveIsNotMadeUpForAllAtOnce) {
    const Curve wanted{{{0, 20}, {1, 20}, {3, 10}, {9, 10}}};
    Scenario scenario = following(wanted);
    scenario.road.friction = 0.25;
    const Log log = simulate(shared::compact(), scenario);
    EXPECT_GT(valueAt(log, "chassis.vx", 3), 13) << "the road gives 2.5 m/s2 of the 5";
    EXPECT_NEAR(valueAt(log, "chassis.vx", 6), 10, 0.3);
    EXPECT_NEAR(valueAt(log, "chassis.vx", 9), 10, 0.02);
    const std::vector<double>& speed = channel(log, "chassis.vx");
    EXPECT_GT(*std::min_element(speed.begin(), speed.end()), 9.7);
}

TEST(SpeedFollower, PedalsAreLeftAlone) {
    const Log log = simulate(shared::compact(), following(kSteps));
    EXPECT_EQ(shared::peak(log, "driver.throttle"), 0);
    EXPECT_EQ(valueAt(log, "driver.force_command", 5), 1);
    EXPECT_EQ(valueAt(log, "driver.brake", 8), 0);
    EXPECT_GT(valueAt(log, "driver.longitudinal_force", 4), 4 * 1350);
    EXPECT_LT(valueAt(log, "driver.longitudinal_force", 8), -5 * 1350);
}

}  // namespace
}  // namespace tread::speed_follower_test
