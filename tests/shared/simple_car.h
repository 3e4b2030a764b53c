// A car of three lines in place of the simulation: yaw rate by steering ratio and wheelbase, which seems longer by the
// square of the speed times `steering.play` (it understeers), speed by drag; nothing else.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/math/random.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/options.h"
#include "places/places.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"
#include "tread/load.h"

namespace tread::simple_car {

inline void drive(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder, const Pushing&) {
    const std::vector<Column> columns = recordedColumns(scenario.log.channels);
    recorder.begin(columns);
    const Phase& phase = scenario.phases.back();
    const auto rows = static_cast<int>(*phase.until.duration / scenario.step) + 1;
    for (int k = 0; k <= rows; ++k) {
        const double t = k * scenario.step, v = scenario.start.speed - 0.3 * car.aero.drag_area * t;
        const double steer = valueAt(phase.steering, 0, t), length = car.wheelbase + car.steering.play * v * v;
        const std::map<std::string, double> shown{{"time", t},
                                                  {"driver.steering_wheel_angle", steer},
                                                  {"chassis.vx", v},
                                                  {"chassis.yaw_rate", v * steer / (car.steering.ratio * length)}};
        std::vector<double> row(columns.size(), 0);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (const auto found = shown.find(columns[i].name); found != shown.end()) row[i] = found->second;
        recorder.row(row);
    }
}

struct Case {
    recording::Subject nominal{
        .vehicle = loadVehicle(sourceFile("vehicles/compact.yaml")), .road = {}, .wind = {}, .instruments = {}};
    recording::DiagnosisFile file;
    recording::Recorded recorded;
};

// A slalom, straight on at first.
inline Scenario slalom(double speed) {
    Scenario scenario;
    scenario.start.speed = speed;
    scenario.step = 0.01;
    Curve angle{{{0, 0}}};
    for (double t = 0.2; t < 4; t += 0.05) angle.points.push_back({t, 0.5 * std::sin(2 * (t - 0.2))});
    Phase phase;
    phase.steering = Table<Angle>{angle};
    phase.until.duration = 4;
    scenario.phases = {phase};
    return scenario;
}

// Recordings of a true car, with noise.
inline Case recorded(const VehicleParams& truth, const std::vector<Scenario>& drives, std::uint64_t seed,
                     const recording::Simulate& simulate = drive) {
    Case made;
    Random random(seed);
    for (const Scenario& told : drives) {
        recording::Recording recording;
        recording.log = recording.name = "drive " + std::to_string(made.recorded.logs.size() + 1);
        made.file.recordings.push_back(recording);
        Scenario scenario = told;
        scenario.log.channels = {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate"};
        Log log;
        simulate(truth, scenario, recorderInto(log), {});
        for (Channel& channel : log.channels) {
            const double noise = channel.name == "chassis.vx" ? 0.02 : channel.name == "chassis.yaw_rate" ? 0.003 : 0;
            for (double& value : channel.values) value += noise * random.normal();
        }
        made.recorded.logs.push_back(std::move(log));
    }
    return made;
}

// Three slaloms of a car with another steering ratio and drag area.
inline Case recorded(double ratio, double drag_area, std::uint64_t seed) {
    VehicleParams truth = Case{}.nominal.vehicle;
    truth.steering.ratio = ratio;
    truth.aero.drag_area = drag_area;
    return recorded(truth, {slalom(15), slalom(20), slalom(25)}, seed);
}

inline diagnose::Options options(int threads = 2) {
    diagnose::Options options;
    options.simulate = drive;
    options.threads = threads;
    return options;
}

inline diagnose::catalogue::Effect effect(const char* name, const char* path) {
    return {name, "", "", {{.paths = {path}, .typical = 0.1, .relative = true}}};
}

}  // namespace tread::simple_car
