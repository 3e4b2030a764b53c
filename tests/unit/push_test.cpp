// What pushes a car moves it as Newton says, and its instruments feel it.
#include <gtest/gtest.h>

#include "run/simulate.h"
#include "shared/vehicles.h"

namespace tread::push_test {
namespace {

constexpr double kSpeed = 20;    // m/s
constexpr double kStep = 0.001;  // s, from row to row: the tyres have not answered yet after one

Log straight(const Pushing& pushing) {
    Scenario scenario;
    scenario.start.speed = kSpeed;
    scenario.step = kStep;
    scenario.log.rate = 1 / kStep;
    scenario.phases.resize(1);
    scenario.phases[0].until.duration = 1;
    Log log;
    simulate(reference::compact(), scenario, recorderInto(log), pushing);
    return log;
}

Pushing constant(const Push& push) {
    return [=](double, const VehicleInput&, const VehicleOutput&) { return push; };
}

TEST(Push, ForceForwardAcceleratesTheWholeMass) {
    constexpr double kForce = 500;  // N
    const Log pushed = straight(constant({.force = {kForce, 0, 0}})), free = straight({});
    const double mass = reference::compact().mass;
    const std::vector<double>& ax = pushed.find("chassis.ax")->values;
    const double gained = pushed.find("chassis.vx")->values.back() - free.find("chassis.vx")->values.back();
    EXPECT_NEAR(ax[1] - free.find("chassis.ax")->values[1], kForce / mass, 0.01 * kForce / mass);
    // Later wheels and engine turn faster, too: about a tenth more inertia in the fifth gear, and more drag.
    EXPECT_LT(gained, kForce / mass);
    EXPECT_GT(gained, 0.8 * kForce / mass);
}

TEST(Push, AccelerationIsTheDerivativeOfTheVelocity) {
    const Log log = straight(constant({.force = {300, 0, 0}, .moment = {0, 0, 0}}));
    const auto &ax = log.find("chassis.ax")->values, &vx = log.find("chassis.vx")->values;
    double integral = 0;
    for (std::size_t i = 1; i < ax.size(); ++i) integral += 0.5 * kStep * (ax[i] + ax[i - 1]);
    EXPECT_NEAR(integral, vx.back() - vx.front(), 0.005);
}

TEST(Push, MomentToTheLeftTurnsToTheLeftByTheYawInertia) {
    constexpr double kMoment = 1000;  // N m
    const Log log = straight(constant({.moment = {0, 0, kMoment}}));
    EXPECT_NEAR(log.find("chassis.yaw_rate")->values[1], kStep * kMoment / reference::compact().inertia.yaw,
                0.02 * kStep * kMoment / reference::compact().inertia.yaw);
}

// What depends on the time alone leaves the run with less to look at, and every row as it is.
TEST(Push, OverTimeAloneGivesTheSameRows) {
    for (const MovedBy by : {MovedBy::bullet, MovedBy::itself}) {
        Scenario scenario;
        scenario.start.speed = kSpeed;
        scenario.step = 4 * kStep;
        scenario.log.channels = {"chassis.ax", "chassis.ay", "chassis.roll", "chassis.yaw_rate", "*.spin"};
        scenario.phases.resize(1);
        scenario.phases[0].until.duration = 1;
        const auto at = [](double time) {
            return Push{.force = {100, 400 * time, 0}, .moment = {50, 0, 200 - 300 * time}};
        };
        Log over_time, asked;
        simulate(reference::compact(), scenario, recorderInto(over_time), PushingOverTime{at}, by);
        simulate(
            reference::compact(), scenario, recorderInto(asked),
            [&](double time, const VehicleInput&, const VehicleOutput&) { return at(time); }, by);
        ASSERT_EQ(over_time.channels.size(), 9u);
        for (std::size_t c = 0; c < asked.channels.size(); ++c)
            EXPECT_EQ(over_time.channels[c].values, asked.channels[c].values) << asked.channels[c].name;
    }
}

TEST(Push, NoneLeavesTheRunAsItIs) {
    const Log none = straight({}), nothing = straight(constant({}));
    for (std::size_t c = 0; c < none.channels.size(); ++c)
        EXPECT_EQ(none.channels[c].values, nothing.channels[c].values) << none.channels[c].name;
}

}  // namespace
}  // namespace tread::push_test
