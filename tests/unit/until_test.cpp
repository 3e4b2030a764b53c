#include "scenario/until.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/yaml/read.h"
#include "scenario/driver.h"

namespace tread::until_test {
namespace {

// Each event with a car that is just short of it, and one for which it has come true.
struct Case {
    const char* until;
    void (*set)(Observed&, double sign);  // sign +1: it happened
};

Until untilOf(const std::string& text) {
    return readYamlText<Until>(text, "until.yaml");
}

TEST(Until, EachEventComesTrueBeyondItsLimitOnly) {
    constexpr double kBit = 1e-6;
    for (const Case& c : {
             Case{"speed_below: 10", [](Observed&o, double s) { o.car.vx = 10 - s * kBit; }},
             Case{"speed_above: 10", [](Observed&o, double s) { o.car.vx = 10 + s * kBit; }},
             Case{"lateral_acceleration_above: 4", [](Observed&o, double s) { o.car.ay = -4 - s * kBit; }},
             Case{"lateral_acceleration_below: 4", [](Observed&o, double s) { o.car.ay = -4 + s * kBit; }},
             Case{"sideslip_above: 0.5", [](Observed&o, double s) { o.car.sideslip = -0.5 - s * kBit; }},
             Case{"steering_above: 2", [](Observed&o, double s) { o.steering_wheel_angle = -2 - s * kBit; }},
             Case{"distance: 50", [](Observed&o, double s) { o.distance = 50 + s * kBit; }},
             Case{"x_above: 50", [](Observed&o, double s) { o.car.x = 50 + s * kBit; }},
             Case{"x_below: -50", [](Observed&o, double s) { o.car.x = -50 - s * kBit; }},
             Case{"y_above: 3", [](Observed&o, double s) { o.car.y = 3 + s * kBit; }},
             Case{"y_below: 3", [](Observed&o, double s) { o.car.y = 3 - s * kBit; }},
             Case{"yaw_rate_zero: true",
                  [](Observed&o, double s) {
                      o.yaw_rate_before = 0.1;
                      o.car.yaw_rate = -s * kBit;
                  }},
         }) {
        const Until until = untilOf(c.until);
        Observed short_of, beyond;
        short_of.car.x = beyond.car.x = 0;
        c.set(short_of, -1);
        c.set(beyond, 1);
        EXPECT_FALSE(happened(until, short_of)) << c.until;
        EXPECT_TRUE(happened(until, beyond)) << c.until;
        EXPECT_FALSE(happened(untilOf("duration: 1"), beyond)) << c.until;
        EXPECT_NE(wordsOf(until), "") << c.until;
    }
}

TEST(Until, AFieldThatIsFalseIsNoCondition) {
    EXPECT_THROW(untilOf("yaw_rate_zero: false"), LoadError);
}

// A car whose yaw rate is a cosine: the second phase ends with its first zero after the phase began, not with one
// before.
TEST(Until, YawRateZeroCountsFromTheBeginningOfThePhase) {
    const auto scenario = readYamlText<Scenario>(
        "phases:\n  - until: {duration: 2}\n  - until: {yaw_rate_zero: true}\n", "scenario.yaml");
    Driver driver(scenario, {});
    double t = 0;
    for (; t < 20 && !driver.finished(t); t += 0.01) {
        ChassisOutput car;
        car.vx = 10;
        car.yaw_rate = std::cos(t);  // zero at 1.571 and 4.712
        driver.look(t, car);
        driver.inputAt(t + 0.01);
    }
    EXPECT_NEAR(t, 4.712, 0.025);
}

TEST(Until, TimeCountsFromTheBeginningOfTheManoeuvre) {
    const auto scenario = readYamlText<Scenario>(
        "phases:\n  - until: {duration: 2}\n  - until: {time: 5}\n  - {steering: {constant: {value: 1}}, until: "
        "{duration: "
        "10, time: 7}}\n",
        "scenario.yaml");
    Driver driver(scenario, {});
    for (double t = 0; t < 6.9; t += 0.1) {
        driver.look(t, {});
        EXPECT_FALSE(driver.finished(t)) << t;
        EXPECT_EQ(driver.inputAt(t + 0.1).steering_wheel_angle, t + 0.1 > 5 + 1e-6 ? 1 : 0) << t;
    }
    EXPECT_TRUE(driver.finished(7));
}

}  // namespace
}  // namespace tread::until_test
