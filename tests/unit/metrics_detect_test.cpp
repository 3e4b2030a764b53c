#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "metrics_sample.h"

namespace tread::metrics_detect_test {
namespace {

using namespace sample;

// A log with every channel that a simulation writes, at rest; tests overwrite what their manoeuvre moves.
Log everything(double duration, const std::vector<Signal>& moved) {
    std::vector<Signal> signals;
    for (const auto& [name, unit] :
         std::vector<std::pair<const char*, const char*>>{{"driver.steering_wheel_angle", "rad"},
                                                          {"driver.throttle", "-"},
                                                          {"driver.brake", "-"},
                                                          {"chassis.x", "m"},
                                                          {"chassis.y", "m"},
                                                          {"chassis.z", "m"},
                                                          {"chassis.roll", "rad"},
                                                          {"chassis.yaw", "rad"},
                                                          {"chassis.vx", "m/s"},
                                                          {"chassis.vy", "m/s"},
                                                          {"chassis.yaw_rate", "rad/s"},
                                                          {"chassis.ax", "m/s2"},
                                                          {"chassis.ay", "m/s2"},
                                                          {"chassis.az", "m/s2"},
                                                          {"chassis.sideslip", "rad"}}) {
        std::function<double(double)> value = constant(0);
        for (const Signal& signal : moved) {
            if (signal.name == name) value = signal.value;
        }
        signals.push_back({name, unit, value});
    }
    return log(100, duration, signals);
}

// A quasi-static car: yaw rate and lateral acceleration follow the steering at once.
Log steered(double duration, const std::function<double(double)>& angle) {
    return everything(duration, {{"driver.steering_wheel_angle", "", angle},
                                 {"driver.throttle", "", constant(0.2)},
                                 {"chassis.vx", "", constant(22)},
                                 {"chassis.yaw_rate", "", [=](double t) { return 0.4 * angle(t); }},
                                 {"chassis.ay", "", [=](double t) { return 8.8 * angle(t); }}});
}

std::string detected(const Log& log) {
    try {
        return detectManoeuvre(log);
    } catch (const MetricError& error) {
        return error.what();
    }
}

TEST(DetectManoeuvre, EachManoeuvreIsKnownByItsInputs) {
    EXPECT_EQ(detected(everything(10, {})), "parked");
    EXPECT_EQ(
        detected(everything(10, {{"chassis.z", "", [](double t) { return 0.1 * std::exp(-t) * std::cos(8 * t); }}})),
        "drop_and_settle");
    EXPECT_EQ(
        detected(everything(10, {{"chassis.vx", "", [](double t) { return std::clamp(28 - 8 * (t - 1), 0.0, 28.0); }},
                                 {"driver.brake", "", [](double t) { return t < 1 ? 0.0 : 0.7; }}})),
        "straight_braking");
    EXPECT_EQ(detected(everything(40, {{"chassis.vx", "", [](double t) { return 30 - 0.3 * t; }}})), "coast_down");
    EXPECT_EQ(detected(steered(8, [](double t) { return std::clamp((t - 1) / 0.15, 0.0, 1.0) * 0.5; })), "step_steer");
    EXPECT_EQ(detected(steered(12, [](double t) { return t < 1 ? 0 : 0.4 * std::sin(3 * (t - 1)); })), "sine_steer");
    EXPECT_EQ(detected(steered(40, [](double t) { return t < 1 ? 0 : 0.02 * (t - 1); })), "steady_circle");
}

TEST(DetectManoeuvre, ALogWithoutAKnownManoeuvreSaysWhatWasLookedFor) {
    // A double lane change shows only beside the course that was driven.
    const auto lane_change = [](double t) {
        const double a = 0.8 * std::exp(-8 * (t - 2) * (t - 2)) - std::exp(-8 * (t - 2.7) * (t - 2.7));
        return a + 0.7 * std::exp(-8 * (t - 4.4) * (t - 4.4)) - 0.5 * std::exp(-8 * (t - 5.2) * (t - 5.2));
    };
    const std::string why = detected(steered(8, lane_change));
    EXPECT_EQ(why.find("the log contains none of the known manoeuvres:"), 0u) << why;
    for (const Manoeuvre& known : manoeuvres()) {
        const std::string name(known.name);
        EXPECT_NE(why.find("no " + name + " in this log: "), std::string::npos) << name << ": " << why;
    }
    EXPECT_NE(detected(sample::log(100, 5, {})).find("no step_steer in this log: it needs driver.steering_wheel_angle"),
              std::string::npos);
}

TEST(Metrics, AnUnknownManoeuvreIsAnErrorThatListsTheKnownOnes) {
    const std::string why = errorOf(everything(5, {}), "step_stear");
    EXPECT_EQ(why.find("unknown manoeuvre 'step_stear', expected one of "), 0u) << why;
    EXPECT_NE(why.find("step_steer"), std::string::npos);
}

TEST(Metrics, EveryMetricHasANameOnceAUnitAndADefinition) {
    for (const auto& [log, manoeuvre] : std::vector<std::pair<Log, std::string>>{
             {everything(10, {}), "parked"},
             {steered(8, [](double t) { return std::clamp((t - 1) / 0.15, 0.0, 1.0) * 0.5; }), "step_steer"},
             {steered(12, [](double t) { return t < 1 ? 0 : 0.4 * std::sin(3 * (t - 1)); }), "sine_steer"},
             {steered(40, [](double t) { return t < 1 ? 0 : 0.02 * (t - 1); }), "steady_circle"}}) {
        std::set<std::string> names;
        for (const Metric& metric : metrics(log, manoeuvre)) {
            EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
            EXPECT_FALSE(metric.unit.empty()) << metric.name;
            EXPECT_GT(metric.definition.size(), 10u) << metric.name;
        }
    }
}

TEST(Metrics, UndefinedValuesAreWordsInTextAndNullInJson) {
    const std::vector<Metric> list = {{"tb", std::nan(""), "s deg", "undefined here"},
                                      {"speed", 22.5, "m/s", "of the car"}};
    EXPECT_EQ(text("step_steer", list),
              "step_steer: 2 metrics\n\n"
              "tb       undefined  s deg  tb     undefined here\n"
              "speed         22.5  m/s    speed  of the car\n");
    EXPECT_TRUE(json(list)[0]["value"].is_null());
    EXPECT_EQ(json(list)[1]["value"], 22.5);
    EXPECT_EQ(json(list)[1]["unit"], "m/s");
}

}  // namespace
}  // namespace tread::metrics_detect_test
