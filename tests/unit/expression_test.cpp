// Expressions: what they are, which unit they have, and their values against numbers by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "metrics/own/evaluate.h"
#include "metrics/own/own_metrics.h"
#include "scenario/expression/check.h"
#include "scenario/expression/functions.h"
#include "scenario/expression/moment.h"
#include "scenario/expression/parse.h"

namespace tread::expression_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Two phases in six rows: v rises from 0 to 10 m/s and stays, the roll angle is a triangle up to 0.2 rad and back.
Log sampleLog() {
    Log log;
    log.channels = {{"time", "s", {0, 1, 2, 3, 4, 5}},
                    {"chassis.vx", "m/s", {0, 5, 10, 10, 10, 10}},
                    {"chassis.roll", "rad", {0, 0.1, 0.2, 0.1, 0, -0.1}},
                    {"wheel.front_left.load", "N", {3000, 100, 0, 0, 50, 0}},
                    {"chassis.yaw_rate", "rad/s", {0, 0.5, 0.5, 0.5, 0.5, 0.5}},
                    {"manoeuvre.phase", "-", {1, 1, 1, 2, 2, 2}},
                    {"manoeuvre.phase_start", "s", {0, 0, 0, 2.4, 2.4, 2.4}}};
    return log;
}

KnownNames known() {
    KnownNames names;
    for (const Channel& channel : sampleLog().channels) names.channels.push_back({channel.name, channel.unit});
    names.parameters = {{"vehicle.mass", "kg"}};
    names.phases = {"straight", "turn"};
    return names;
}

// The value in SI; NaN where the expression is undefined.
double valueOf(const std::string& text, const std::string& unit = "-") {
    ExpressionFault fault;
    std::optional<Term> term = parseExpression(text, fault);
    if (!term || !checkMetric(*term, unit, known(), fault)) {
        ADD_FAILURE() << text << ": " << fault.at << ": " << fault.text;
        return kNan;
    }
    return evaluate(*term, sampleLog(), {{"vehicle.mass", "kg", 1500}}, known().phases);
}

ExpressionFault faultOf(const std::string& text, const std::string& unit = "-") {
    ExpressionFault fault{999, ""};
    std::optional<Term> term = parseExpression(text, fault);
    if (term && checkMetric(*term, unit, known(), fault)) ADD_FAILURE() << text << " is no fault";
    return fault;
}

TEST(Expression, ArithmeticFollowsTheUsualRules) {
    EXPECT_DOUBLE_EQ(valueOf("1 + 2 * 3"), 7);
    EXPECT_DOUBLE_EQ(valueOf("(1 + 2) * 3"), 9);
    EXPECT_DOUBLE_EQ(valueOf("10 - 4 - 3"), 3);
    EXPECT_DOUBLE_EQ(valueOf("12 / 4 / 3"), 1);
    EXPECT_DOUBLE_EQ(valueOf("-2 ^ 2"), -4);
    EXPECT_DOUBLE_EQ(valueOf("2 * -3"), -6);
    EXPECT_DOUBLE_EQ(valueOf("1.5e2 + .5"), 150.5);
    EXPECT_DOUBLE_EQ(valueOf("1 < 2 and not 2 < 1 or 1 > 2"), 1);
    EXPECT_DOUBLE_EQ(valueOf("sqrt(16) + abs(-1) + sign(-3) + lower(1, 2) + higher(1, 2) + hypot(3, 4)"), 12);
    EXPECT_DOUBLE_EQ(valueOf("sin(90 deg) + cos(0) + tan(45 deg)"), 3);
    EXPECT_DOUBLE_EQ(valueOf("atan2(1, 1)", "rad"), std::numbers::pi / 4);
}

TEST(Expression, NumbersHaveUnitsThatReachAsFarAsUnitsFollow) {
    EXPECT_DOUBLE_EQ(valueOf("36 km/h", "m/s"), 10);
    EXPECT_DOUBLE_EQ(valueOf("2 * 3 m", "m"), 6);
    EXPECT_DOUBLE_EQ(valueOf("20 m / max(chassis.vx)", "s"), 2);
    EXPECT_DOUBLE_EQ(valueOf("0.5 g / 1 m/s2"), 4.903325);
    EXPECT_DOUBLE_EQ(valueOf("3 N m + 1 N m", "N m"), 4);
    EXPECT_DOUBLE_EQ(valueOf("50 %"), 0.5);
    EXPECT_DOUBLE_EQ(valueOf("vehicle.mass * 1 m/s2", "kN"), 1500) << "SI; shown in the unit by ownMetrics()";
}

TEST(Expression, ReductionsAreThoseOfStraightLinesBetweenTheSamples) {
    EXPECT_DOUBLE_EQ(valueOf("max(chassis.vx)", "m/s"), 10);
    EXPECT_DOUBLE_EQ(valueOf("min(chassis.roll)", "rad"), -0.1);
    EXPECT_DOUBLE_EQ(valueOf("mean(chassis.vx)", "m/s"), 8);
    EXPECT_DOUBLE_EQ(valueOf("integral(chassis.vx)", "m"), 40);
    EXPECT_DOUBLE_EQ(valueOf("integral(chassis.vx, 0.5 s, 1.5 s)", "m"), 5);
    EXPECT_DOUBLE_EQ(valueOf("rms(chassis.vx, 0 s, 2 s)", "m/s"), std::sqrt(100.0 / 3));
    EXPECT_DOUBLE_EQ(valueOf("first(chassis.vx, 1.5 s)", "m/s"), 7.5);
    EXPECT_DOUBLE_EQ(valueOf("last(chassis.roll)", "rad"), -0.1);
    EXPECT_DOUBLE_EQ(valueOf("at(chassis.vx, 0.2 s)", "m/s"), 1);
    EXPECT_DOUBLE_EQ(valueOf("max(abs(chassis.roll), 3.5 s, 4.5 s)", "rad"), 0.05);
    EXPECT_DOUBLE_EQ(valueOf("max(rate(chassis.vx))", "m/s2"), 5);
    EXPECT_DOUBLE_EQ(valueOf("max(chassis.vx * chassis.yaw_rate)", "m/s2"), 5) << "the radian counts as 1";
    EXPECT_NEAR(valueOf("max(smoothed(chassis.roll, 1 s))", "rad"), 0.15, 1e-12);
    EXPECT_TRUE(std::isnan(valueOf("at(chassis.vx, 9 s)", "m/s"))) << "beyond the log";
}

TEST(Expression, ConditionsBeginAndEndBetweenTheSamples) {
    EXPECT_DOUBLE_EQ(valueOf("time_of(chassis.vx > 2.5 m/s)", "s"), 0.5);
    EXPECT_DOUBLE_EQ(valueOf("time_of(chassis.roll < 0.05 rad, 2 s)", "s"), 3.5);
    EXPECT_TRUE(std::isnan(valueOf("time_of(chassis.vx > 11 m/s)", "s")));
    EXPECT_DOUBLE_EQ(valueOf("duration(chassis.roll >= 0.1 rad)", "s"), 2);
    EXPECT_DOUBLE_EQ(valueOf("duration(chassis.roll > 0.05 rad and chassis.vx < 7.5 m/s)", "s"), 1);
    EXPECT_DOUBLE_EQ(valueOf("longest(wheel.front_left.load == 0)", "s"), 1);
    EXPECT_DOUBLE_EQ(valueOf("count(wheel.front_left.load == 0)"), 2);
    EXPECT_DOUBLE_EQ(valueOf("duration(not wheel.front_left.load > 0)", "s"), 1);
}

TEST(Expression, PhasesAreKnownByNameAndNumber) {
    EXPECT_DOUBLE_EQ(valueOf("start(\"turn\")", "s"), 2.4);
    EXPECT_DOUBLE_EQ(valueOf("start(2)", "s"), 2.4);
    EXPECT_DOUBLE_EQ(valueOf("end(1)", "s"), 2.4);
    EXPECT_DOUBLE_EQ(valueOf("start(1)", "s"), 0);
    EXPECT_DOUBLE_EQ(valueOf("end('turn') - start()", "s"), 5);
    EXPECT_DOUBLE_EQ(valueOf("max(chassis.roll, start(2))", "rad"), 0.16);
}

TEST(Expression, FaultsSayWhereAndWhat) {
    const auto expect = [](const std::string& text, std::size_t at, const std::string& words,
                           const std::string& unit = "-") {
        const ExpressionFault fault = faultOf(text, unit);
        EXPECT_EQ(fault.at, at) << text << ": " << fault.text;
        EXPECT_NE(fault.text.find(words), std::string::npos) << text << ": " << fault.text;
    };
    expect("max(chassis.rol)", 4, "did you mean \"chassis.roll\"?", "rad");
    expect("maxx(chassis.roll)", 0, "did you mean \"max\"?", "rad");
    expect("1 + ", 4, "the end of the expression");
    expect("(1 + 2", 0, "not closed");
    expect("1 2", 2, "after a complete expression");
    expect("3 knots", 2, "unknown unit");
    expect("max(chassis.vx) + max(chassis.roll)", 16, "an angle added to a speed", "m/s");
    expect("max(chassis.vx) > 5", 16, "write the unit after the number");
    expect("max(chassis.vx)", 0, "found a speed, but the metric states the unit \"deg\"", "deg");
    expect("max(chassis.roll)", 0, "found an angle", "-");
    expect("chassis.vx", 0, "found values over time, expected one number", "m/s");
    expect("max(chassis.vx > 5 m/s)", 15, "found a condition, expected a number");
    expect("duration(chassis.vx)", 9, "expected a condition", "s");
    expect("max(chassis.vx, 3)", 16, "expected a time", "m/s");
    expect("max()", 0, "expected max(x [, from [, to]])", "m/s");
    expect("start(\"trun\")", 6, "did you mean \"turn\"?", "s");
    expect("start(3)", 6, "a number from 1 to 2", "s");
    expect("vehicle.mas * 1", 0, "did you mean \"vehicle.mass\"?", "kg");
    expect("1 < 2 < 3", 6, "a second comparison");
    expect("sqrt(max(chassis.vx))", 0, "which has no unit");
    expect("max(chassis.vx) ^ 0.5", 18, "not a whole number");
    expect(std::string(200, '('), 64, "levels");
}

// A moment has no whole log, and a rate of change none in its first step.
TEST(Expression, OfAMomentKnowsTheStepBefore) {
    KnownNames names = known();
    names.at_one_moment = true;
    ExpressionFault fault;
    std::optional<Term> term = parseExpression("abs(rate(chassis.roll)) < 0.5 rad/s and chassis.vx >= 3 m/s", fault);
    ASSERT_TRUE(term && checkCondition(*term, names, fault)) << fault.text;
    double roll = 0, vx = 3;
    MomentaryExpression now(*term, [&](std::string_view name) { return name == "chassis.vx" ? &vx : &roll; });
    EXPECT_FALSE(now.holds(0)) << "no rate yet";
    roll = 0.06;
    EXPECT_FALSE(now.holds(0.1)) << "0.6 rad/s";
    roll = 0.10;
    EXPECT_TRUE(now.holds(0.2)) << "0.4 rad/s";
    vx = 2.9;
    EXPECT_FALSE(now.holds(0.3));
    now.begin();
    vx = 3;
    EXPECT_FALSE(now.holds(0.4));
    EXPECT_TRUE(now.holds(0.5));

    term = parseExpression("max(chassis.vx) > 3 m/s", fault);
    EXPECT_FALSE(checkCondition(*term, names, fault));
    EXPECT_NE(fault.text.find("needs a whole log"), std::string::npos) << fault.text;
    term = parseExpression("rate(chassis.vx)", fault);
    EXPECT_FALSE(checkCondition(*term, names, fault));
    EXPECT_NE(fault.text.find("compare it with a value"), std::string::npos) << fault.text;
}

TEST(Expression, EveryFunctionIsEvaluated) {
    for (const FunctionAbout& about : functions()) {
        EXPECT_EQ(functionNamed(about.name), &about);
        EXPECT_LE(about.least, about.most);
    }
    EXPECT_EQ(callOf(*functionNamed("max")), "max(x [, from [, to]])");
    EXPECT_EQ(callOf(*functionNamed("atan2")), "atan2(y, x)");
    EXPECT_EQ(callOf(*functionNamed("start")), "start([phase])");
}

}  // namespace
}  // namespace tread::expression_test
