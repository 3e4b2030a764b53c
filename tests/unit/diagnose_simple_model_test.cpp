// The whole diagnosis on a car of two lines: fast, and its answer can be seen by eye.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "diagnose/diagnosis_json.h"
#include "places/places.h"
#include "tread/load.h"

namespace tread {
namespace {

// Yaw rate by steering ratio and wheelbase, speed by drag; nothing else.
void simpleCar(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder, const Pushing&) {
    const std::vector<Column> columns = recordedColumns(scenario.log.channels);
    recorder.begin(columns);
    const Phase& phase = scenario.phases.back();
    const auto rows = static_cast<int>(*phase.until.duration / scenario.step) + 1;
    for (int k = 0; k <= rows; ++k) {
        const double t = k * scenario.step, v = scenario.start.speed - 0.3 * car.aero.drag_area * t;
        const double r = v * valueAt(phase.steering, 0, t) / (car.steering.ratio * car.wheelbase);
        std::vector<double> row(columns.size(), 0);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string& name = columns[i].name;
            row[i] = name == "time" ? t : name == "chassis.vx" ? v : name == "chassis.yaw_rate" ? r : 0;
        }
        recorder.row(row);
    }
}

Effect effect(const char* name, const char* path) {
    return {name, "", "", {{.paths = {path}, .typical = 0.1, .relative = true}}};
}

Diagnosis diagnosed(double ratio, int threads) {
    Subject nominal{
        .vehicle = loadVehicle(sourceFile("vehicles/compact.yaml")), .road = {}, .wind = {}, .instruments = {}};
    DiagnosisFile file;
    std::vector<Log> logs;
    Random random(3);
    for (const double speed : {15.0, 20.0, 25.0}) {
        Recording recording;
        recording.log = recording.name = "at " + std::to_string(static_cast<int>(speed));
        file.recordings.push_back(recording);
        Log log{{{"time", "s", {}},
                 {"driver.steering_wheel_angle", "rad", {}},
                 {"chassis.vx", "m/s", {}},
                 {"chassis.yaw_rate", "rad/s", {}}}};
        for (int k = 0; k < 400; ++k) {
            const double t = 0.01 * k, steer = 0.5 * std::sin(2 * t);
            const double v = speed - 0.3 * nominal.vehicle.aero.drag_area * t;
            const double values[] = {t, steer, v + 0.02 * random.normal(),
                                     v * steer / (ratio * nominal.vehicle.wheelbase) + 0.003 * random.normal()};
            for (std::size_t i = 0; i < 4; ++i) log.channels[i].values.push_back(values[i]);
        }
        logs.push_back(std::move(log));
    }
    DiagnoseOptions options;
    options.simulate = simpleCar;
    options.threads = threads;
    return diagnose(nominal, file, logs, {effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")},
                    options);
}

TEST(DiagnosisOfASimpleCar, AnotherSteeringRatioIsNamedWithItsSize) {
    const Diagnosis d = diagnosed(14.5, 2);
    EXPECT_EQ(d.verdict, Verdict::explained) << d.answer;
    ASSERT_EQ(d.causes, std::vector<std::string>{"ratio"});
    const Estimate ratio = d.effects.front().parameters.at("steering.ratio");
    EXPECT_NEAR(ratio.value, 14.5, 3 * ratio.sd);
    EXPECT_GT(d.where.channels.at("chassis.yaw_rate"), 0.9);
}

TEST(DiagnosisOfASimpleCar, NominalCarHasNothingBeyondTolerance) {
    const Diagnosis d = diagnosed(16.5, 2);
    EXPECT_EQ(d.verdict, Verdict::nothing) << d.answer;
}

TEST(DiagnosisOfASimpleCar, AnswerIsTheSameToTheBitForOneAndTwoThreads) {
    Diagnosis one = diagnosed(14.5, 1), two = diagnosed(14.5, 2);
    one.seconds = two.seconds = 0;
    EXPECT_EQ(diagnosisJson(one).dump(), diagnosisJson(two).dump());
}

}  // namespace
}  // namespace tread
