// Events on channels, and metrics of the user's own, through the program.

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/tread_run.h"
#include "log/csv.h"

namespace tread::own_metrics_test {
namespace {

using Json = nlohmann::json;

const std::string kTurn =
    "title: Turn\n"
    "start: {speed: 80 km/h}\n"
    "phases:\n"
    "  - {name: straight, until: {duration: 0.2 s}}\n"
    "  - {name: turn, steering: {ramp: {to: 40 deg, rate: 400 deg/s}}, until: {after_steering: 0.1 s}}\n"
    "  - name: back\n"
    "    steering: {rescale: {factor: -0.5, duration: 0.2 s}}\n"
    "    until: {when: \"rate(chassis.roll) < -2 deg/s and chassis.ay < 3 m/s2\", duration: 3 s}\n";

struct OwnMetrics : TreadRun {
    OwnMetrics() { car(); }
    Json metric(const std::string& name) const {
        const Json result = Json::parse(contentOf(out("metrics.json")));
        for (const Json& one : result["metrics"]) {
            if (one["name"] == name) return one;
        }
        ADD_FAILURE() << "no metric " << name;
        return {};
    }
    double valueOf(const std::string& name) const {
        const Json one = metric(name);
        return one["value"].is_null() ? std::nan("") : one["value"].get<double>();
    }
    // A fault that the run and `tread check` refuse at the same place.
    void expectRefusal(const std::string& text, const std::string& at, const std::string& fault) {
        const std::string file = scenario(text);
        const std::string place = file + ":" + placeOf(text, at) + ": ";
        const Result drive = run(), check = runProgram({"check", file});
        EXPECT_EQ(drive.status, 2) << drive.out;
        EXPECT_EQ(drive.err.find(place), 0u) << drive.err << place;
        EXPECT_NE(drive.err.find(fault), std::string::npos) << drive.err;
        EXPECT_NE(check.out.find(place), std::string::npos) << check.out;
    }
};

TEST_F(OwnMetrics, PhasesEndOnChannelsTheirRatesAndTheEndOfTheSteering) {
    scenario(kTurn);
    const Result result = run();
    ASSERT_EQ(result.status, 0) << result.err;
    const Log log = readLog(out("log.csv"));
    const std::vector<double>&phase = log.find("manoeuvre.phase")->values,
          &start = log.find("manoeuvre.phase_start")->values;
    EXPECT_EQ(phase.front(), 1);
    EXPECT_EQ(phase.back(), 3);
    // The ramp to 40 deg takes 0.1 s, and 0.1 s pass.
    EXPECT_NEAR(start.back(), 0.4, 1e-9);
    // The last row is the first step in which the condition is met.
    EXPECT_LT(log.find("chassis.ay")->values.back(), 3);
    EXPECT_LT(log.channels.front().values.back(), 3);
    // On its way to half of the angle on the other side, for which it takes 0.2 s.
    const double on = std::min(1.0, (log.channels.front().values.back() - 0.4) / 0.2);
    EXPECT_NEAR(log.find("driver.steering_wheel_angle")->values.back() * 57.29577951, 40 - 60 * on, 0.5);
}

TEST_F(OwnMetrics, StandOnThePageInTheFileAndInAccept) {
    scenario(kTurn +
             "metrics:\n"
             "  - name: peak_roll\n"
             "    unit: deg\n"
             "    definition: largest roll angle of the turn\n"
             "    value: max(abs(chassis.roll), start(\"turn\"))\n"
             "  - {name: turn_begins, unit: ms, value: start(2)}\n"
             "  - {name: weight, unit: kN, value: \"vehicle.mass * 1 g\"}\n"
             "  - {name: entry, unit: km/h, value: \"at(chassis.vx, start('turn')) + 0 * scenario.start.speed\"}\n"
             "  - {name: never, unit: s, value: time_of(chassis.vx > 100 m/s)}\n"
             "accept: {peak_roll: \"< 4 deg\", turn_begins: \"200 ms +- 1 %\"}\n");
    const Result result = run();
    ASSERT_EQ(result.status, 0) << result.err << result.out;
    const Log log = readLog(out("log.csv"));
    double roll = 0;
    for (const double value : log.find("chassis.roll")->values) roll = std::max(roll, std::abs(value));
    EXPECT_NEAR(valueOf("peak_roll"), roll * 57.29577951308232, 1e-9);
    EXPECT_EQ(metric("peak_roll")["unit"], "deg");
    EXPECT_NEAR(valueOf("turn_begins"), 200, 1e-6);
    EXPECT_NEAR(valueOf("entry"), 80, 0.5);
    EXPECT_GT(valueOf("weight"), 9);
    EXPECT_TRUE(std::isnan(valueOf("never")));
    EXPECT_NE(result.out.find("accepted: 2 conditions met"), std::string::npos) << result.out;
    const std::string page = contentOf(out("report.html"));
    EXPECT_NE(page.find("largest roll angle of the turn"), std::string::npos);
    // What was resolved repeats the run, metrics and all.
    EXPECT_NE(contentOf(out("run.yaml")).find("largest roll angle of the turn"), std::string::npos);
}

TEST_F(OwnMetrics, AFileAddsThemToARunAndToALog) {
    scenario(kTurn);
    const std::string file = scratch.file("mine.yaml",
                                          "metrics:\n"
                                          "  - {name: way, unit: m, value: integral(chassis.vx)}\n"
                                          "  - {name: mass, unit: t, value: vehicle.mass}\n");
    const std::string accept = scratch.file("accept.yaml", "accept: {way: \"< 1 m\"}\n");
    const Result result = run({"--metrics", file, "--accept", accept});
    EXPECT_EQ(result.status, 1) << result.err;
    const double way = valueOf("way");
    EXPECT_GT(way, 10);
    const Result again = runProgram({"metrics", out("log.csv"), "--metrics", file, "--json"});
    ASSERT_EQ(again.status, 0) << again.err;
    const Json told = Json::parse(again.out);
    ASSERT_GE(told["metrics"].size(), 2u);
    for (const Json& one : told["metrics"]) {
        if (one["name"] == "way") {
            EXPECT_EQ(one["value"].get<double>(), way);
        } else if (one["name"] == "mass") {
            EXPECT_TRUE(one["value"].is_null()) << "the log does not say the car";
        }
    }
    const Result of_car =
        runProgram({"metrics", out("log.csv"), "--metrics", file, "--vehicle", scratch.path("car.yaml")});
    EXPECT_NE(of_car.out.find("mass"), std::string::npos);
    EXPECT_EQ(runProgram({"check", file}).out, "1 file is fine\n" + file + ": own_metrics, fine\n");
}

TEST_F(OwnMetrics, InASeriesEveryRunHasThem) {
    scenario(kTurn +
             "metrics: [{name: peak, unit: deg/s, value: max(chassis.yaw_rate)}]\n"
             "series: {vary: {number: phases.1.steering.ramp.to, values: [20 deg, 40 deg]}}\n");
    const Result result = run();
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string table = contentOf(out("series.csv"));
    EXPECT_NE(table.find(",peak [deg/s]\n"), std::string::npos) << table;
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
}

TEST_F(OwnMetrics, FaultsAreRefusedAtTheirPlaceWithinTheExpression) {
    const std::string start = kTurn + "metrics:\n  - {name: peak, unit: deg, value: \"";
    expectRefusal(start + "max(abs(chassis.rol))\"}\n", "chassis.rol)", "did you mean \"chassis.roll\"?");
    expectRefusal(start + "max(chassis.vx)\"}\n", "max(chassis.vx)", "found a speed, but the metric states the unit");
    expectRefusal(start + "start('trun') * 1 deg\"}\n", "'trun'", "did you mean \"turn\"?");
    expectRefusal(start + "max(chassis.roll\"}\n", "max(chassis.roll\"", "closing parenthesis");
    expectRefusal(kTurn +
                      "metrics:\n  - name: folded\n    unit: deg\n    value: >-\n      max(chassis.roll) +\n"
                      "      max(chassis.vx)\n",
                  "+\n      max(chassis.vx)", "a speed added to an angle");
    expectRefusal(replaced(kTurn, "rate(chassis.roll)", "rate(chassis.rolll)"), "chassis.rolll",
                  "did you mean \"chassis.roll\"?");
    expectRefusal(replaced(kTurn, "< 3 m/s2", "< 3"), "< 3\"", "write the unit after the number");
    EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(OwnMetrics, DescribeListsFunctionsAndAnExample) {
    const Result result = runProgram({"describe", "expressions"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("max(x [, from [, to]])"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("start(\"countersteer\")"), std::string::npos) << result.out;
}

// The shipped rollover tests, with the compact car.
TEST_F(OwnMetrics, FishhooksAndJTurnFollowTheirRecipe) {
    const auto drive = [&](const std::string& name) {
        const Result result = runProgram({"run", scratch.path("car.yaml"), kSource + "/scenarios/" + name + ".yaml",
                                          "-o", out(), "--set", "scenario.step=0.002"});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return readLog(out("log.csv"));
    };
    const Log fixed = drive("fishhook_1a");
    const double angle = valueOf("steering_angle");
    EXPECT_NEAR(valueOf("reversal_time"), angle / 720 + 0.25, 0.03);
    EXPECT_EQ(valueOf("two_wheel_lift"), 0);
    // Angle at 0.3 g by the slowly increasing steer, times 6.5.
    const Result slow =
        runProgram({"run", scratch.path("car.yaml"), kSource + "/scenarios/slowly_increasing_steer.yaml", "-o", out(),
                    "--set", "scenario.step=0.002"});
    ASSERT_EQ(slow.status, 0) << slow.err;
    EXPECT_NEAR(6.5 * valueOf("steering_angle_03g"), angle, 1);

    const Log watched = drive("fishhook_1b");
    // At the reversal the roll angle is at its largest of that side.
    const std::vector<double>&phase = watched.find("manoeuvre.phase")->values,
          &roll = watched.find("chassis.roll")->values;
    const std::size_t reversal = static_cast<std::size_t>(std::find(phase.begin(), phase.end(), 4.0) - phase.begin());
    ASSERT_LT(reversal, phase.size());
    EXPECT_GT(roll[reversal],
              0.95 * *std::max_element(roll.begin(), roll.begin() + static_cast<std::ptrdiff_t>(reversal)));
    EXPECT_GT(valueOf("reversal_time"), angle / 720);
    EXPECT_LT(valueOf("reversal_time"), angle / 720 + 0.6);

    drive("j_turn");
    EXPECT_NEAR(valueOf("steering_angle"), angle * 8 / 6.5, 1);
}

}  // namespace
}  // namespace tread::own_metrics_test
