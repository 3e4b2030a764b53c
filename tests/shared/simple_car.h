// A car of two lines in place of the simulation: yaw rate by steering ratio and wheelbase, speed by drag; nothing else.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "diagnose/diagnosis.h"
#include "places/places.h"
#include "tread/load.h"

namespace tread::simple_car {

inline void simulate(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder) {
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

struct Case {
    Subject nominal{
        .vehicle = loadVehicle(sourceFile("vehicles/compact.yaml")), .road = {}, .wind = {}, .instruments = {}};
    DiagnosisFile file;
    std::vector<Log> logs;
};

// Three slaloms of a car with another steering ratio and drag area, with noise.
inline Case recorded(double ratio, double drag_area, std::uint64_t seed) {
    Case made;
    Random random(seed);
    for (const double speed : {15.0, 20.0, 25.0}) {
        Recording recording;
        recording.log = recording.name = "at " + std::to_string(static_cast<int>(speed));
        made.file.recordings.push_back(recording);
        Log log{{{"time", "s", {}},
                 {"driver.steering_wheel_angle", "rad", {}},
                 {"chassis.vx", "m/s", {}},
                 {"chassis.yaw_rate", "rad/s", {}}}};
        for (int k = 0; k < 400; ++k) {
            const double t = 0.01 * k, v = speed - 0.3 * drag_area * t;
            const double steer = 0.5 * std::sin(2 * std::max(0.0, t - 0.2));  // straight on at first
            const double values[] = {t, steer, v + 0.02 * random.normal(),
                                     v * steer / (ratio * made.nominal.vehicle.wheelbase) + 0.003 * random.normal()};
            for (std::size_t i = 0; i < 4; ++i) log.channels[i].values.push_back(values[i]);
        }
        made.logs.push_back(std::move(log));
    }
    return made;
}

inline DiagnoseOptions options(int threads = 2) {
    DiagnoseOptions options;
    options.simulate = simulate;
    options.threads = threads;
    return options;
}

inline Effect effect(const char* name, const char* path) {
    return {name, "", "", {{.paths = {path}, .typical = 0.1, .relative = true}}};
}

}  // namespace tread::simple_car
