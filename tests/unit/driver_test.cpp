#include "scenario/driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/yaml/read.h"
#include "scenario/load.h"

namespace tread::driver_test {
namespace {

constexpr double kRounding = 1e-12;

Scenario scenarioOf(const std::string& phases) {
    return readYamlText<Scenario>("phases:\n" + phases, "scenario.yaml");
}

ChassisOutput at(double speed, double lateral_acceleration = 0) {
    ChassisOutput chassis;
    chassis.vx = speed;
    chassis.ay = lateral_acceleration;
    return chassis;
}

// Drives a car that keeps its speed; returns the inputs at the ends of the steps until the scenario is over.
struct Drive {
    std::vector<double> time;  // s
    std::vector<VehicleInput> input;
    double end = 0;  // s
};
Drive drive(const Scenario& scenario, double dt, double speed = 20, const VehicleInput& initial = {}) {
    constexpr long kMostSteps = 100000;
    Driver driver(scenario, initial);
    Drive result;
    for (long k = 0; k < kMostSteps; ++k) {
        const double now = static_cast<double>(k) * dt;
        driver.look(now, at(speed));
        result.end = now;
        if (driver.finished(now)) return result;
        result.time.push_back(static_cast<double>(k + 1) * dt);
        result.input.push_back(driver.inputAt(result.time.back()));
    }
    ADD_FAILURE() << "the scenario did not end";
    return result;
}

// ---- Phases by time ----

TEST(Driver, PhaseByTimeStartsAtTheSameTimeWhateverTheStep) {
    const Scenario scenario = scenarioOf(R"(
  - until: {duration: 0.505}
  - {steering: {ramp: {to: 10, rate: 2}}, until: {duration: 1}}
)");
    for (const double dt : {1 / 60.0, 1 / 1000.0, 0.037, 0.0125}) {
        const Drive result = drive(scenario, dt);
        for (std::size_t i = 0; i < result.time.size(); ++i) {
            const double expected = std::max(0.0, 2 * (result.time[i] - 0.505));
            ASSERT_NEAR(result.input[i].steering_wheel_angle, expected, kRounding)
                << "step " << dt << ", time " << result.time[i];
        }
        EXPECT_GE(result.end, 1.505 - 1e-9) << dt;
        EXPECT_LT(result.end, 1.505 + dt) << dt;
    }
}

TEST(Driver, ScenarioEndsInTheStepThatEndsWithItDespiteRounding) {
    // 0.1 added up is not a multiple of a thousandth in binary: the end must not slip into the next step.
    const Scenario scenario = scenarioOf(R"(
  - until: {duration: 0.1}
  - until: {duration: 0.1}
  - until: {duration: 0.1}
)");
    EXPECT_NEAR(drive(scenario, 0.001).end, 0.3, kRounding);
    EXPECT_NEAR(drive(scenario, 0.1).end, 0.3, kRounding);
}

TEST(Driver, SeveralPhasesMayPassWithinOneStep) {
    const Scenario scenario = scenarioOf(R"(
  - {steering: {ramp: {to: 1, rate: 10}}, until: {duration: 0.01}}
  - {steering: {ramp: {to: -1, rate: 10}}, until: {duration: 0.02}}
  - {steering: keep, until: {duration: 1}}
)");
    Driver driver(scenario, {});
    driver.look(0, at(20));
    EXPECT_NEAR(driver.inputAt(0.05).steering_wheel_angle, 0.1 - 0.2, kRounding);
}

TEST(Driver, NextPhaseContinuesFromTheExactEndOfTheLast) {
    // The ramp is cut at 0.205 s, inside a step of both kinds; what is held is its value there.
    const Scenario scenario = scenarioOf(R"(
  - {steering: {ramp: {to: 10, rate: 2}}, brake: {ramp: {to: 1, rate: 1}}, until: {duration: 0.205}}
  - until: {duration: 0.5}
)");
    for (const double dt : {1 / 60.0, 1 / 1000.0}) {
        const Drive result = drive(scenario, dt);
        EXPECT_NEAR(result.input.back().steering_wheel_angle, 0.41, kRounding) << dt;
        EXPECT_NEAR(result.input.back().brake, 0.205, kRounding) << dt;
    }
}

// ---- Conditions ----

// Time at which the first phase gives way to the second, which steers; the car at time t is `car(t)`.
template <class Car>
double phaseEnd(const std::string& until, Car car) {
    const Scenario scenario = scenarioOf("  - {until: {" + until + R"(}}
  - {steering: {constant: {value: 1}}, until: {duration: 1}}
)");
    constexpr double kStep = 0.01;
    Driver driver(scenario, {});
    for (int k = 0; k < 1000; ++k) {
        const double now = k * kStep;
        driver.look(now, car(now));
        if (driver.inputAt(now + kStep).steering_wheel_angle == 1) return now;
    }
    return -1;
}

TEST(Driver, SpeedBelowEndsThePhaseWhenTheCarIsSlower) {
    EXPECT_NEAR(phaseEnd("speed_below: 15", [](double t) { return at(20 - 5 * t); }), 1.01, kRounding);
    EXPECT_EQ(phaseEnd("speed_below: 15", [](double) { return at(15); }), -1);
}

TEST(Driver, SpeedAboveEndsThePhaseWhenTheCarIsFaster) {
    EXPECT_NEAR(phaseEnd("speed_above: 25", [](double t) { return at(20 + 5 * t); }), 1.01, kRounding);
    EXPECT_EQ(phaseEnd("speed_above: 25", [](double) { return at(25); }), -1);
}

TEST(Driver, LateralAccelerationCountsToBothSides) {
    const std::string until = "lateral_acceleration_above: 4";
    EXPECT_NEAR(phaseEnd(until, [](double t) { return at(20, 3.99 * t); }), 1.01, kRounding);
    EXPECT_NEAR(phaseEnd(until, [](double t) { return at(20, -3.99 * t); }), 1.01, kRounding);
}

TEST(Driver, DistanceIsTheWayInThePlaneForwardsOrSideways) {
    const auto diagonal = [](double) {
        ChassisOutput chassis;
        chassis.vx = 3;
        chassis.vy = -4;
        return chassis;
    };
    EXPECT_NEAR(phaseEnd("distance: 9.99", diagonal), 2, kRounding);
}

TEST(Driver, FirstConditionThatComesTrueEndsThePhase) {
    const auto slowing = [](double t) { return at(20 - 5 * t); };
    EXPECT_NEAR(phaseEnd("duration: 0.5, speed_below: 15", slowing), 0.5, kRounding);
    EXPECT_NEAR(phaseEnd("duration: 3, speed_below: 15", slowing), 1.01, kRounding);
    EXPECT_NEAR(phaseEnd("speed_below: 15, distance: 5.01", slowing), 0.26, 0.011);
}

TEST(Driver, DistanceAndDurationCountFromTheBeginningOfTheirPhase) {
    const Scenario scenario = scenarioOf(R"(
  - until: {distance: 9.99}
  - until: {distance: 9.99}
  - until: {duration: 0.5}
)");
    EXPECT_NEAR(drive(scenario, 0.01).end, 0.5 + 0.5 + 0.5, kRounding);
}

TEST(Driver, ConditionOfTheLastPhaseEndsTheScenario) {
    const Scenario scenario = scenarioOf("  - until: {speed_below: 15}\n");
    Driver driver(scenario, {});
    driver.look(0, at(20));
    EXPECT_FALSE(driver.finished(0));
    driver.look(0.1, at(14));
    EXPECT_TRUE(driver.finished(0.1));
}

// ---- Keep and hold speed ----

TEST(Driver, WhatAPhaseDoesNotNameStaysAsInTheEquilibrium) {
    const Scenario scenario = scenarioOf("  - until: {duration: 0.1}\n");
    const VehicleInput initial{.steering_wheel_angle = 0.01, .throttle = 0.2, .brake = 0.3, .clutch = 0.4};
    for (const VehicleInput& input : drive(scenario, 0.01, 20, initial).input) {
        EXPECT_EQ(input.steering_wheel_angle, 0.01);
        EXPECT_EQ(input.throttle, 0.2);
        EXPECT_EQ(input.brake, 0.3);
        EXPECT_EQ(input.clutch, 0.4);
    }
}

TEST(Driver, HandsOffLeavesTheSteeringWheelAndTakesItUpWhereItIs) {
    const Scenario scenario = scenarioOf(
        "  - {steering: {constant: {value: 0.5}}, until: {duration: 0.1}}\n"
        "  - {steering: hands_off, until: {duration: 0.1}}\n"
        "  - {steering: keep, until: {duration: 0.1}}\n");
    Driver driver(scenario, {});
    for (int k = 0; k < 30; ++k) {
        const double angle = k < 10 ? 0.5 : 0.5 - 0.02 * (k - 10);  // of the steering wheel, as the car shows it
        driver.look(0.01 * k, at(20), k < 20 ? angle : 0.3);
        const VehicleInput input = driver.inputAt(0.01 * (k + 1));
        EXPECT_EQ(input.hands_off, k >= 10 && k < 20 ? 1 : 0) << k;
        const double expected = k < 10 ? 0.5 : k < 20 ? angle : 0.3;  // at last where the hands found it
        EXPECT_EQ(input.steering_wheel_angle, expected) << k;
    }
}

const char* const kHoldFrom = R"(
  - until: {duration: 0.1}
  - {throttle: {hold_speed: {speed: %, proportional: 0.1, integral: 0.05}}, until: {duration: 10}}
)";
std::string withSpeed(const std::string& speed) {
    std::string text = kHoldFrom;
    return text.replace(text.find('%'), 1, speed);
}

TEST(Driver, HoldSpeedAddsToTheThrottleThatWasHeld) {
    const Scenario scenario = scenarioOf(withSpeed("22"));
    const Drive result = drive(scenario, 0.01, 20, {.throttle = 0.1});
    // Two m/s are missing: 0.2 at once, 0.1 a second by the integral.
    const auto throttleAt = [&](double time) {
        return result.input[static_cast<std::size_t>(std::lround(time / 0.01)) - 1].throttle;
    };
    EXPECT_NEAR(throttleAt(0.1), 0.1, kRounding);
    EXPECT_NEAR(throttleAt(0.11), 0.3, 0.0011);
    EXPECT_NEAR(throttleAt(1.1), 0.4, 0.0011);
    EXPECT_NEAR(throttleAt(3.1), 0.6, 0.0011);
}

TEST(Driver, HoldSpeedReleasesThePedalWhenTheCarIsFaster) {
    const Scenario scenario = scenarioOf(withSpeed("18"));
    const Drive result = drive(scenario, 0.01, 20, {.throttle = 0.3});
    EXPECT_NEAR(result.input[10].throttle, 0.1, 0.0011);
    EXPECT_EQ(result.input.back().throttle, 0);
}

TEST(Driver, HoldSpeedNeverPressesThePedalThroughTheFloor) {
    const Scenario scenario = scenarioOf(withSpeed("60"));
    for (const VehicleInput& input : drive(scenario, 0.01, 20, {.throttle = 0.3}).input) {
        ASSERT_GE(input.throttle, 0);
        ASSERT_LE(input.throttle, 1);
    }
}

TEST(Driver, HoldSpeedReleasesThePedalAtOnceAfterALongTimeAtTheFloor) {
    const Scenario scenario = scenarioOf(
        "  - {throttle: {hold_speed: {speed: 60, proportional: 0.1, integral: 0.05}}, "
        "until: {duration: 200}}\n");
    Driver driver(scenario, {.throttle = 0.3});
    for (int second = 0; second < 100; ++second) driver.look(second, at(20));
    EXPECT_EQ(driver.inputAt(99.01).throttle, 1);
    driver.look(99.01, at(62));
    EXPECT_NEAR(driver.inputAt(99.02).throttle, 1 - 0.1 * 2 - 0.05 * 0.01 * 2, kRounding);
}

TEST(Driver, HoldSpeedWithoutSpeedHoldsThatAtTheBeginningOfItsPhase) {
    const Scenario scenario = scenarioOf(withSpeed("0"));
    Driver driver(scenario, {.throttle = 0.1});
    driver.look(0, at(25));
    driver.inputAt(0.1);
    driver.look(0.1, at(20));
    EXPECT_NEAR(driver.inputAt(0.2).throttle, 0.1, kRounding);
    driver.look(0.2, at(19));
    EXPECT_NEAR(driver.inputAt(0.3).throttle, 0.1 + 0.1 * 1 + 0.05 * 0.1 * 1, kRounding);
}

TEST(Driver, HoldSpeedInTheFirstPhaseHoldsTheSpeedOfTheStart) {
    const Scenario scenario = scenarioOf("  - {throttle: {hold_speed: {}}, until: {duration: 1}}\n");
    for (const VehicleInput& input : drive(scenario, 0.01, 20, {.throttle = 0.2}).input) {
        ASSERT_NEAR(input.throttle, 0.2, kRounding);
    }
}

// ---- What a waiting phase says ----

TEST(Driver, SaysWhichPhaseWaitsForWhatAndWhatTheCarDoes) {
    const Scenario scenario = scenarioOf("  - {name: run up, until: {speed_above: 50, distance: 2000}}\n");
    Driver driver(scenario, {});
    driver.look(0, at(20.0004, -1.5));
    EXPECT_EQ(driver.waitsFor(),
              "phase \"run up\" waits for a speed above 50 m/s or a distance of 2000 m; the car moves at 20 m/s with "
              "1.5 m/s2 of lateral acceleration");
}

TEST(Driver, PhaseWithoutNameIsNamedByItsPath) {
    const Scenario scenario = scenarioOf("  - until: {duration: 1}\n  - until: {speed_below: 1}\n");
    Driver driver(scenario, {});
    driver.look(0, at(20));
    driver.inputAt(1.5);
    EXPECT_EQ(driver.waitsFor(),
              "phases.1 waits for a speed below 1 m/s; the car moves at 20 m/s with 0 m/s2 of lateral acceleration");
}

// ---- Scenario files ----

std::string faultOf(const std::string& text) {
    try {
        readYamlText<Scenario>(text, "scenario.yaml");
    } catch (const LoadError& error) {
        return error.what();
    }
    return "no fault";
}

TEST(Scenario, FirstPhaseWithoutEndIsAFaultWithItsPlace) {
    EXPECT_EQ(faultOf("phases:\n  - until: {duration: 1}\n  - name: circle\n  - until: {duration: 1}\n"),
              "scenario.yaml:3:5: phases.1.until.duration: found no condition, expected at least one (duration, "
              "time, speed_below, speed_above, lateral_acceleration_above, lateral_acceleration_below, "
              "sideslip_above, steering_above, distance, x_above, x_below, y_above, y_below, after_steering, laps, "
              "when, yaw_rate_zero or "
              "drive_end), or the phase would never end");
}

TEST(Scenario, WithoutPhasesIsAFault) {
    EXPECT_EQ(faultOf("title: nothing to do\n"),
              "scenario.yaml:1:1: phases: found no phase, expected at least one that says what the driver does and "
              "until when");
}

TEST(Scenario, RollingStartWithTheBrakesOnIsAFault) {
    EXPECT_EQ(faultOf("start: {speed: 20, brake: 0.5}\nphases: [{until: {duration: 1}}]\n"),
              "scenario.yaml:1:27: start.brake: a car that starts at a speed cannot have its brakes on; put the "
              "braking into a phase");
}

TEST(Scenario, PedalBeyondTheFloorIsAFault) {
    EXPECT_EQ(faultOf("phases:\n  - {brake: {constant: {value: 1.5}}, until: {duration: 1}}\n"),
              "scenario.yaml:2:32: phases.0.brake.constant.value: found \"1.5\", expected a pure number from 0 to 1; "
              "correct the value");
}

TEST(Scenario, LongestDurationAddsThePhasesUpToTheTimeLimit) {
    Scenario scenario = scenarioOf("  - until: {duration: 1}\n  - until: {duration: 2.5, speed_below: 1}\n");
    EXPECT_DOUBLE_EQ(longestDuration(scenario), 3.5);
    scenario.time_limit = 3;
    EXPECT_DOUBLE_EQ(longestDuration(scenario), 3);
    scenario.phases[0].until.duration.reset();
    scenario.phases[0].until.speed_below = 1;
    scenario.time_limit = 100;
    EXPECT_DOUBLE_EQ(longestDuration(scenario), 100);
}

}  // namespace
}  // namespace tread::driver_test
