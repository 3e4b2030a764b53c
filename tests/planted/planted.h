// Drives of a car with a known fault, recorded as a proving ground would.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "base/math/random.h"
#include "diagnose/answer/diagnosis.h"
#include "places/places.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"
#include "run/simulate.h"
#include "tread/load.h"

namespace tread::planted {

inline constexpr double kDegree = 0.017453292519943295;

struct Noise {
    std::string channel;
    double sd;
};
inline const std::vector<Noise> kNoise{
    {"driver.steering_wheel_angle", 0},
    {"driver.throttle", 0},
    {"driver.brake", 0},
    {"chassis.vx", 0.03},
    {"chassis.ax", 0.1},
    {"chassis.ay", 0.1},
    {"chassis.yaw_rate", 0.003},
    {"chassis.roll", 0.001},
    {"chassis.roll_rate", 0.005},
    {"wheel.front_left.spin", 0.1},
    {"wheel.front_right.spin", 0.1},
    {"wheel.rear_left.spin", 0.1},
    {"wheel.rear_right.spin", 0.1},
};

inline Phase phase(double seconds) {
    Phase phase;
    phase.until.duration = seconds;
    return phase;
}

inline Scenario drive(double speed, std::vector<Phase> phases) {
    Scenario scenario;
    scenario.start.speed = speed;
    scenario.phases = {phase(0.5)};
    scenario.phases.insert(scenario.phases.end(), phases.begin(), phases.end());
    scenario.log.rate = 100;
    for (const Noise& noise : kNoise) scenario.log.channels.push_back(noise.channel);
    return scenario;
}

inline Scenario stepSteer(double speed, double angle) {
    Phase turn = phase(3);
    turn.steering = Ramp<Angle>{.to = angle, .rate = 500 * kDegree};
    return drive(speed, {turn});
}

inline Scenario sweep(double speed) {
    Phase turn = phase(6);
    turn.steering =
        Sweep<Angle>{.amplitude = 20 * kDegree, .from = 0.3, .to = 3, .duration = 6, .law = SweepLaw::logarithmic};
    return drive(speed, {turn});
}

inline Scenario braking(double speed, double pedal) {
    Phase brake = phase(2.5);
    brake.throttle = Ramp<Pedal>{.to = 0, .rate = 5};
    brake.brake = Ramp<Pedal>{.to = pedal, .rate = 5};
    return drive(speed, {brake});
}

inline Scenario coasting(double speed) {
    Phase coast = phase(5);
    coast.throttle = Ramp<Pedal>{.to = 0, .rate = 5};
    return drive(speed, {coast});
}

inline VehicleParams nominalCar() {
    return loadVehicle(sourceFile("vehicles/compact.yaml"));
}

struct Case {
    recording::Subject nominal;
    recording::DiagnosisFile file;
    std::vector<Log> logs;
};

// The true car in each drive, with white noise on every channel. The wind is that of each scenario.
inline Case recorded(const recording::Subject& truth, const std::vector<std::pair<std::string, Scenario>>& drives,
                     std::size_t held_out = 0) {
    Case made;
    made.nominal.vehicle = nominalCar();
    made.file.vehicle = "compact.yaml";
    Random random(7);
    for (std::size_t i = 0; i < drives.size(); ++i) {
        recording::Recording recording;
        recording.log = drives[i].first + ".csv";
        recording.name = drives[i].first;
        recording.hold_out = i + held_out >= drives.size();
        made.file.recordings.push_back(recording);
        Scenario scenario = drives[i].second;
        scenario.road = truth.road;
        Log log = simulate(truth.vehicle, scenario);
        for (Channel& channel : log.channels) {
            for (const Noise& noise : kNoise) {
                if (noise.channel != channel.name) continue;
                for (double& value : channel.values) value += noise.sd * random.normal();
            }
        }
        made.logs.push_back(std::move(log));
    }
    return made;
}

}  // namespace tread::planted
