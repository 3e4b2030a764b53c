// From foreign columns to the channels of a log: units, signs, factors, time.
#include "import/import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/yaml/read.h"
#include "shared/foreign_logs.h"
#include "shared/import_problems.h"

namespace tread::import_test {
namespace {

using foreign::Column;

ForeignTable drive(const std::vector<double>& times = foreign::times()) {
    return parseForeignCsv(foreign::table(foreign::loggerColumns(), times), "x.csv");
}

ImportMap mapOf(const std::string& text) {
    return readYamlText<ImportMap>(text, "map.yaml");
}

const char* const kMap =
    "time: {from: Time}\n"
    "map:\n"
    "  - {channel: chassis.vx, from: Speed}\n"
    "  - {channel: chassis.yaw_rate, from: Yaw rate, sign: -1}\n"
    "  - {channel: chassis.ay, from: Lateral acceleration}\n"
    "  - {channel: driver.steering_wheel_angle, from: Steering wheel angle}\n";

std::size_t countOf(const Imported& result, const std::string& kind, const std::string& channel = {}) {
    std::size_t count = 0;
    for (const Change& change : result.changes) {
        if (change.kind == kind && (channel.empty() || change.channel == channel)) count += change.count;
    }
    return count;
}

TEST(Import, BringsUnitsAndSignsToOurs) {
    const Imported result = importLog(drive(), mapOf(kMap));
    ASSERT_EQ(result.logs.size(), 1u);
    const Log& log = result.logs[0];
    for (std::size_t i : {0u, 77u, 500u}) {
        const double t = 0.01 * static_cast<double>(i);
        EXPECT_NEAR(valuesOf(log, "time")[i], t, 1e-12);
        EXPECT_NEAR(valuesOf(log, "chassis.vx")[i], foreign::kSpeed, 1e-6);
        EXPECT_NEAR(valuesOf(log, "chassis.yaw_rate")[i], foreign::yawRate(t), 1e-8);
        EXPECT_NEAR(valuesOf(log, "chassis.ay")[i], foreign::lateralAcceleration(t), 1e-7);
        EXPECT_NEAR(valuesOf(log, "driver.steering_wheel_angle")[i], foreign::steering(t), 1e-8);
    }
    EXPECT_EQ(log.find("chassis.ay")->unit, "m/s2");
    EXPECT_EQ(countOf(result, "unit", "chassis.ay"), 501u);
    EXPECT_EQ(countOf(result, "sign", "chassis.yaw_rate"), 501u);
    EXPECT_EQ(countOf(result, "doubt"), 0u) << text(result.changes);
    EXPECT_NE(text(result.changes).find("chassis.ay: g to m/s2\n"), std::string::npos);
}

TEST(Import, AWrongSignAndAWrongUnitAreDoubted) {
    std::string wrong = kMap;
    wrong.replace(wrong.find(", sign: -1"), 10, "");
    const std::string said = text(importLog(drive(), mapOf(wrong)).changes);
    EXPECT_NE(said.find("chassis.ay and chassis.vx times chassis.yaw_rate have opposite signs"), std::string::npos);
    EXPECT_NE(said.find("driver.steering_wheel_angle and chassis.yaw_rate have opposite signs"), std::string::npos);

    std::string unit = kMap;
    unit.replace(unit.find("from: Lateral acceleration"), 26, "from: Lateral acceleration, unit: m/s2");
    EXPECT_NE(text(importLog(drive(), mapOf(unit)).changes).find("as if one of them were in g"), std::string::npos);
}

TEST(Import, FactorsOffsetsMeansAndConstants) {
    const ForeignTable table = parseForeignCsv("t,fl,fr,w,x\ns,deg,deg,km/h,degC\n0,1,3,36,20\n1,2,6,72,30\n", "x.csv");
    const Log log = importLog(table, mapOf("time: {from: t}\n"
                                           "map:\n"
                                           "  - {channel: driver.steering_wheel_angle, from: fl, mean_with: [fr], "
                                           "scale: 16, offset: 0.1}\n"
                                           "  - {channel: wheel.front_left.spin, from: w, rolling_radius: 0.5}\n"
                                           "  - {channel: brake.temperature, from: x}\n"
                                           "constants:\n"
                                           "  - {channel: chassis.vx, value: 90, unit: km/h}\n"))
                        .logs[0];
    EXPECT_NEAR(valuesOf(log, "driver.steering_wheel_angle")[1], 16 * 4 * foreign::kDegree + 0.1, 1e-12);
    EXPECT_NEAR(valuesOf(log, "wheel.front_left.spin")[1], 40, 1e-12);
    EXPECT_EQ(log.find("wheel.front_left.spin")->unit, "rad/s");
    EXPECT_NEAR(valuesOf(log, "brake.temperature")[0], 293.15, 1e-12);
    EXPECT_EQ(log.find("brake.temperature")->unit, "K");
    EXPECT_EQ(valuesOf(log, "chassis.vx"), (std::vector<double>{25, 25}));
}

TEST(Import, ACurveStandsForACharacteristicThatIsNotALine) {
    const ForeignTable table = parseForeignCsv("t [s],s [-]\n0,-2\n1,-0.5\n2,0.25\n3,1\n", "x.csv");
    const Imported result = importLog(table, mapOf("time: {from: t}\n"
                                                   "map:\n"
                                                   "  - {channel: driver.steering_wheel_angle, from: s, unit: rad, "
                                                   "curve: [[-1, -0.4], [0, 0], [1, 0.2]], scale: 10, offset: 1}\n"));
    const std::vector<double> angle = valuesOf(result.logs[0], "driver.steering_wheel_angle");
    const double expected[] = {-3, -1, 1.5, 3};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(angle[i], expected[i], 1e-12) << i;
    EXPECT_EQ(countOf(result, "curve"), 4u) << "it is said";
}

TEST(Import, TakesTheBeginningOutAsZero) {
    const ForeignTable table = parseForeignCsv("t [s],a [m/s2]\n0,0.2\n1,0.4\n2,5\n", "x.csv");
    const Imported result =
        importLog(table, mapOf("time: {from: t}\nmap: [{channel: chassis.ax, from: a, zero_over: 1}]\n"));
    EXPECT_NEAR(valuesOf(result.logs[0], "chassis.ax")[2], 4.7, 1e-12);
    EXPECT_EQ(countOf(result, "zero"), 3u);
}

// A delayed sine: taking the delay out gives the sine itself.
TEST(Import, TakesADelayOutAndCutsWhatItDoesNotReach) {
    const std::vector<Column> columns{{"t", "s", [](double t) { return t; }},
                                      {"r", "rad/s", [](double t) { return std::sin(t - 0.05); }},
                                      {"a", "m/s2", [](double t) { return std::sin(t); }}};
    const ForeignTable table = parseForeignCsv(foreign::table(columns, foreign::times()), "x.csv");
    const Imported result = importLog(table, mapOf("time: {from: t}\nmap:\n"
                                                   "  - {channel: chassis.yaw_rate, from: r, delay: 50 ms}\n"
                                                   "  - {channel: chassis.ay, from: a}\n"));
    const Log& log = result.logs[0];
    ASSERT_EQ(log.samples(), 496u);
    EXPECT_EQ(countOf(result, "cut"), 5u);
    for (std::size_t i = 0; i < log.samples(); ++i) {
        EXPECT_NEAR(valuesOf(log, "chassis.yaw_rate")[i], valuesOf(log, "chassis.ay")[i], 1e-7);
    }
}

TEST(Import, AFileWithoutTimeIsCountedAtItsRate) {
    const ForeignTable table = parseForeignCsv("a [m/s2]\n1\n2\n3\n", "x.csv");
    const Imported result = importLog(table, mapOf("time: {rate: 250}\nmap: [{channel: chassis.ay, from: a}]\n"));
    EXPECT_EQ(valuesOf(result.logs[0], "time"), (std::vector<double>{0, 0.004, 0.008}));
    EXPECT_EQ(countOf(result, "time"), 3u);
    EXPECT_EQ(faultsOf([&] { importLog(table, mapOf("map: [{channel: chassis.ay, from: a}]\n")); }),
              "time: found neither a time column (from) nor a sampling rate (rate); give one of them");
}

TEST(Import, TheClockOfAVboxFileIsReadPastMidnight) {
    ForeignTable table{"x.vbo", "VBOX file", {}, {}, {}};
    table.columns.push_back({"time", "", {235959.98, 235959.99, 0.0, 0.01}, 0, 0, {}});
    table.columns.push_back({"v", "km/h", {36, 36, 36, 36}, 0, 0, {}});
    const Imported result =
        importLog(table, mapOf("time: {from: time, format: hhmmss}\nmap: [{channel: chassis.vx, from: v}]\n"));
    ASSERT_EQ(result.logs[0].samples(), 4u);
    EXPECT_NEAR(valuesOf(result.logs[0], "time")[3], 0.03, 1e-6);
}

TEST(Import, ResamplesLinearlyOrByTheMeanOfTheStep) {
    const ForeignTable table = drive();
    std::string map = std::string(kMap) + "repairs: {rate: 200}\n";
    Imported result = importLog(table, mapOf(map));
    ASSERT_EQ(result.logs[0].samples(), 1001u);
    EXPECT_NEAR(valuesOf(result.logs[0], "chassis.yaw_rate")[333], foreign::yawRate(1.665), 2e-5);
    result = importLog(table, mapOf(std::string(kMap) + "repairs: {rate: 10}\n"));
    ASSERT_EQ(result.logs[0].samples(), 51u);
    EXPECT_EQ(countOf(result, "rate"), 51u);
    // Mean of ten samples of a sine from 4.5 steps before to 4.5 behind, each half a step early.
    double mean = 0;
    for (int k = 195; k < 205; ++k) mean += foreign::yawRate(0.01 * k) / 10;
    EXPECT_NEAR(valuesOf(result.logs[0], "chassis.yaw_rate")[20], mean, 1e-7);
}

TEST(Import, AChannelMayHaveItsOwnTime) {
    ForeignTable table{"x.mat", "MATLAB file", {}, {}, {}};
    table.columns.push_back({"t", "", {0, 1, 2, 3, 4}, 0, 0, {}});
    table.columns.push_back({"t_slow", "", {0, 2, 4}, 0, 0, {}});
    table.columns.push_back({"v", "", {0, 2, 4}, 0, 0, {}});
    const std::string map = "time: {from: t}\nmap: [{channel: chassis.vx, from: v, unit: m/s";
    EXPECT_EQ(valuesOf(importLog(table, mapOf(map + ", time: t_slow}]\n")).logs[0], "chassis.vx"),
              (std::vector<double>{0, 1, 2, 3, 4}));
    EXPECT_EQ(faultsOf([&] { importLog(table, mapOf(map + "}]\n")); }),
              "map.0.from: found 3 values in column \"v\", but 5 in time: another sampling rate; name the column with "
              "its own time (time)");
}

// A car on a circle, whose heading the file counts from -180 to 180 deg.
ForeignTable circling(double turns_per_second) {
    ForeignTable table{"x.mat", "MATLAB file", {}, {}, {}};
    table.columns.push_back({"t", "", {}, 0, 0, {}});
    table.columns.push_back({"heading", "", {}, 0, 0, {}});
    for (int i = 0; i <= 400; ++i) {
        const double t = 0.01 * i;
        table.columns[0].values.push_back(t);
        table.columns[1].values.push_back(std::remainder(360 * turns_per_second * t + 30, 360));
    }
    return table;
}

TEST(Import, ADirectionIsCountedOnBeforeItIsInterpolated) {
    const Imported result =
        importLog(circling(0.7), mapOf("time: {from: t}\nrepairs: {rate: 130}\n"
                                       "map: [{channel: position.heading, from: heading, unit: deg}]\n"));
    const Log& log = result.logs[0];
    ASSERT_EQ(log.samples(), 521u);
    for (std::size_t i = 0; i < log.samples(); ++i) {
        const double t = valuesOf(log, "time")[i];
        ASSERT_NEAR(valuesOf(log, "position.heading")[i], (360 * 0.7 * t + 30) * std::numbers::pi / 180, 1e-9);
    }
    EXPECT_EQ(countOf(result, "turns", "position.heading"), 401u);
    EXPECT_EQ(countOf(result, "spikes"), 0u) << text(result.changes);
}

TEST(Import, ADirectionWithinOneTurnIsLeftAsItIs) {
    const Imported result =
        importLog(circling(0.05), mapOf("time: {from: t}\nmap: [{channel: chassis.yaw, from: heading, unit: deg}]\n"));
    EXPECT_EQ(countOf(result, "turns"), 0u) << text(result.changes);
    EXPECT_NEAR(valuesOf(result.logs[0], "chassis.yaw")[400], 102 * std::numbers::pi / 180, 1e-12);
}

TEST(Import, FaultsOfTheMappingComeAllAtOnceWithTheirPath) {
    const std::string faults = faultsOf([&] {
        importLog(drive(), mapOf("time: {from: Time}\nmap:\n"
                                 "  - {channel: chassis.vx, from: Sped}\n"
                                 "  - {channel: chassis.yaw_rate, from: Speed}\n"
                                 "  - {channel: chassis.ay, from: Lateral acceleration, unit: furlong}\n"));
    });
    EXPECT_EQ(faults,
              "map.0.from: found \"Sped\", which is not a column of x.csv; did you mean \"Speed\"?\n"
              "map.1.from: found a speed (\"km/h\", the unit of column \"Speed\"), expected an angular speed (rad/s); "
              "correct the unit or the channel\n"
              "map.2.unit: found the unknown unit \"furlong\"; write another unit of the same kind, or leave it out");
    const auto named = [](const std::string& name) {
        return faultsOf([&] {
            importLog(drive(), mapOf("time: {from: Time}\nmap: [{channel: " + name +
                                     ", from: Speed}, {channel: a, from: Speed}]\n"));
        });
    };
    EXPECT_EQ(named("a"), "map.1.channel: found \"a\" for the second time; a channel has one source");
    EXPECT_EQ(named("chassis.vx@gps.2").find("map.0.channel: found"), 0u) << "the source is one word";
    EXPECT_EQ(named("chassis.vx@").find("map.0.channel: found"), 0u);
    EXPECT_EQ(named("Chassis.vx").find("map.0.channel: found \"Chassis.vx\", expected the name of a channel"), 0u);
    EXPECT_EQ(faultsOf([] { importLog(drive(), mapOf("time: {from: Time}\n")); }).find("map: found no channel"), 0u);
}

TEST(Import, AColumnThatSaysNoUnitMustGetOneOrIsKeptAsAPureNumber) {
    const ForeignTable table = parseForeignCsv("t,a,b\n0,1,2\n1,2,3\n", "x.csv");
    EXPECT_EQ(faultsOf([&] { importLog(table, mapOf("time: {from: t}\nmap: [{channel: chassis.ay, from: a}]\n")); }),
              "map.0.from: column \"a\" of x.csv has no unit, expected one like m/s2; add a line unit");
    const Log log = importLog(table, mapOf("time: {from: t}\nmap: [{channel: own.b, from: b}]\n")).logs[0];
    EXPECT_EQ(log.find("own.b")->unit, "-");
}

TEST(Import, AWordInAColumnThatIsUsedIsAFaultAtItsPlace) {
    const ForeignTable table = parseForeignCsv("t,vx_mps,note\n0,1,\n0.1,2,hello\n0.2,x,\n", "x.csv");
    EXPECT_EQ(
        faultsOf([&] { importLog(table, mapOf("time: {from: t}\nmap: [{channel: chassis.vx, from: vx_mps}]\n")); }),
        "x.csv:4:5: vx_mps: found \"x\", which is not a number");
}

TEST(ImportGuess, FindsChannelsByNameAndUnit) {
    std::vector<std::string> guesses;
    const ImportMap map = guessMap(drive(), guesses);
    EXPECT_EQ(map.time.from, "Time");
    ASSERT_EQ(map.map.size(), 4u);
    ASSERT_EQ(guesses.size(), 1u) << "names and units are said; the yaw rate is z down";
    EXPECT_NE(guesses[0].find("column Yaw rate has the opposite sign of "), std::string::npos) << guesses[0];
    const Log log = importLog(drive(), map).logs[0];
    EXPECT_NEAR(valuesOf(log, "driver.steering_wheel_angle")[77], foreign::steering(0.77), 1e-8);

    const ForeignTable plain =
        parseForeignCsv("t,vx,delta_h_deg,r,brake_bar,w_fl_kmh\n0,1,2,3,4,5\n1,1,2,3,4,5\n", "x.csv");
    const ImportMap guessed = guessMap(plain, guesses);
    EXPECT_EQ(mappingText(guessed),
              "source: \"guessed from the names of a text table\"\n"
              "time:\n  from: t\n  unit: s\n"
              "map:\n"
              "  - channel: driver.steering_wheel_angle\n    from: delta_h_deg\n    unit: deg\n"
              "  - channel: chassis.vx\n    from: vx\n    unit: m/s\n"
              "  - channel: chassis.yaw_rate\n    from: r\n    unit: rad/s\n"
              "  - channel: wheel.front_left.speed\n    from: w_fl_kmh\n    unit: km/h\n");
    EXPECT_EQ(mapOf(mappingText(guessed)).map.size(), 4u) << "what is written can be read";
    const auto said = [&](const std::string& words) {
        return std::any_of(guesses.begin(), guesses.end(), [&](const std::string& g) { return g.find(words) == 0; });
    };
    EXPECT_TRUE(said("column vx has no unit that tread knows: assumed to be in m/s"));
    EXPECT_TRUE(said("column brake_bar could be driver.brake, but is in bar: left out"));
    EXPECT_TRUE(said("column w_fl_kmh is a speed: with rolling_radius"));
}

// A column that says nothing but its name and its values.
ForeignTable bareTable(const std::vector<Column>& columns) {
    ForeignTable table{"x.csv", "text table", {}, {}, {}};
    for (const Column& column : columns) {
        ForeignColumn made{column.name, column.unit, {}, 0, 0, {}};
        for (const double t : foreign::times()) made.values.push_back(column.value(t));
        table.columns.push_back(std::move(made));
    }
    return table;
}

ImportChannel guessedFor(const ForeignTable& table, const std::string& column) {
    const GuessedMap guessed = guessMap(table);
    for (const ImportChannel& channel : guessed.map.map) {
        if (channel.from == column) return channel;
    }
    return {};
}

TEST(ImportGuess, KnowsTheNamesOfVboxCanAndRos) {
    for (const auto& [column, channel] :
         std::vector<std::pair<const char*, const char*>>{{"SteerAng", "driver.steering_wheel_angle"},
                                                          {"steering_angle", "driver.steering_wheel_angle"},
                                                          {"Steering Angle deg", "driver.steering_wheel_angle"},
                                                          {"delta", "driver.steering_wheel_angle"},
                                                          {"SWA", "driver.steering_wheel_angle"},
                                                          {"omega", "chassis.yaw_rate"},
                                                          {"YAW_RATE_deg_s", "chassis.yaw_rate"},
                                                          {"r", "chassis.yaw_rate"},
                                                          {"imu/angular_velocity.z", "chassis.yaw_rate"},
                                                          {"axCG", "chassis.ax"},
                                                          {"Ax", "chassis.ax"},
                                                          {"acc_x", "chassis.ax"},
                                                          {"ayCG", "chassis.ay"},
                                                          {"linear_acceleration.y", "chassis.ay"},
                                                          {"wheel_fl", "wheel.front_left.spin"},
                                                          {"ws_fl", "wheel.front_left.spin"},
                                                          {"WheelSpeed_FL", "wheel.front_left.spin"},
                                                          {"vFL", "wheel.front_left.spin"},
                                                          {"wheel_speed_rr_kmh", "wheel.rear_right.speed"},
                                                          {"Throttle_pos", "driver.throttle"},
                                                          {"brake_pressure_bar", "brakes.pressure"},
                                                          {"velocity kmh", "chassis.vx"},
                                                          {"twist.linear.x", "chassis.vx"},
                                                          {"acc x (IMU)", "chassis.ax"},
                                                          {"r_vbox_radps", "chassis.yaw_rate"},
                                                          {"heading", "chassis.yaw"}}) {
        const ForeignTable table =
            bareTable({{"t", "s", [](double t) { return t; }}, {column, "", [](double t) { return 0.5 * t; }}});
        EXPECT_EQ(guessedFor(table, column).channel, channel) << column;
    }
}

TEST(ImportGuess, TakesTheUnitThatMakesTheValuesThoseOfACar) {
    const auto unitOf = [](const std::string& name, double peak) {
        return guessedFor(bareTable({{"t", "s", [](double t) { return t; }},
                                     {name, "", [=](double t) { return peak * std::sin(2 * t); }}}),
                          name)
            .unit;
    };
    EXPECT_EQ(unitOf("yaw_rate", 10), "deg/s");
    EXPECT_EQ(unitOf("yaw_rate", 0.4), "rad/s");
    EXPECT_EQ(unitOf("SteerAng", 40), "deg");
    EXPECT_EQ(unitOf("SteerAng", 4), "rad");
    EXPECT_EQ(unitOf("speed", 200), "km/h");
    EXPECT_EQ(unitOf("speed", 30), "m/s");
    EXPECT_EQ(unitOf("ay", 1), "g");
    EXPECT_EQ(unitOf("ay", 10), "m/s2");
    EXPECT_EQ(unitOf("throttle", 80), "%");
    EXPECT_EQ(unitOf("throttle", 0.8), "-");
    EXPECT_EQ(unitOf("roll", 4), "deg");
    EXPECT_EQ(unitOf("engine_speed", 5000), "rpm");
    EXPECT_EQ(unitOf("brake_pressure", 80), "bar");
}

// A gentle drive: 1.0 could be g, but not at this speed and yaw rate; 50 could be m/s, but is km/h.
TEST(ImportGuess, WhatTheChannelsSayOfOneAnotherCorrectsAUnit) {
    const ForeignTable gentle = bareTable({{"t", "s", [](double t) { return t; }},
                                           {"vx", "m/s", [](double) { return 14; }},
                                           {"r", "rad/s", [](double t) { return 0.07 * std::sin(2 * t); }},
                                           {"ay", "", [](double t) { return 0.98 * std::sin(2 * t); }}});
    EXPECT_EQ(guessedFor(gentle, "ay").unit, "m/s2");
    const ForeignTable slow = bareTable({{"t", "s", [](double t) { return t; }},
                                         {"speed", "", [](double) { return 50; }},
                                         {"r", "rad/s", [](double t) { return 0.3 * std::sin(2 * t); }},
                                         {"ay", "m/s2", [](double t) { return 50 / 3.6 * 0.3 * std::sin(2 * t); }}});
    EXPECT_EQ(guessedFor(slow, "speed").unit, "km/h");
    const ForeignTable wheels = bareTable({{"t", "s", [](double t) { return t; }},
                                           {"vx", "m/s", [](double) { return 14; }},
                                           {"ws_fl", "", [](double) { return 14 * 3.6; }},
                                           {"ws_fr", "", [](double) { return 14 / 0.31; }},
                                           {"ws_rl", "", [](double) { return 14.1; }}});
    EXPECT_EQ(guessedFor(wheels, "ws_fl").unit, "km/h");
    EXPECT_EQ(guessedFor(wheels, "ws_fr").unit, "rad/s");
    EXPECT_EQ(guessedFor(wheels, "ws_rl").unit, "m/s");
}

TEST(ImportGuess, ManySpikesDoNotHideTheUnit) {
    const ForeignTable table =
        bareTable({{"t", "s", [](double t) { return t; }},
                   {"SteerAng", "", [](double t) { return t > 2 && t < 2.8 ? 8000 : 60 * std::sin(2 * t); }}});
    EXPECT_EQ(guessedFor(table, "SteerAng").unit, "deg");
}

TEST(ImportGuess, ChannelsOfOneInstrumentShareTheirUnit) {
    const ForeignTable table = bareTable({{"t", "s", [](double t) { return t; }},
                                          {"ax", "", [](double t) { return 0.8 * std::sin(t); }},
                                          {"ay", "", [](double t) { return 9 * std::sin(2 * t); }},
                                          {"yaw_rate", "deg/s", [](double t) { return 2 * std::sin(2 * t); }},
                                          {"roll_rate", "", [](double t) { return 2 * std::cos(2 * t); }}});
    EXPECT_EQ(guessedFor(table, "ax").unit, "m/s2");
    EXPECT_EQ(guessedFor(table, "roll_rate").unit, "deg/s");
}

TEST(ImportGuess, AUnitOfTheFileThatNoCarReachesIsToBeConfirmed) {
    const GuessedMap guessed =
        guessMap(bareTable({{"t", "s", [](double t) { return t; }},
                            {"yaw_rate", "rad/s", [](double t) { return 20 * std::sin(2 * t); }}}));
    ASSERT_EQ(guessed.map.map.size(), 1u);
    EXPECT_EQ(guessed.map.map[0].unit, "rad/s") << "what the file says is not overruled";
    ASSERT_EQ(guessed.guesses.size(), 1u);
    EXPECT_NE(
        mappingText(guessed).find("unit: rad/s  # the file says so, but its values peak at 20 rad/s, above the 3.2 "
                                  "that a road vehicle reaches"),
        std::string::npos)
        << mappingText(guessed);
}

}  // namespace
}  // namespace tread::import_test
