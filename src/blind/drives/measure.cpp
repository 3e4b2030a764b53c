#include "blind/drives/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "blind/world/draws.h"
#include "blind/world/instruments.h"
#include "recording/instruments.h"
#include "run/simulate.h"

namespace tread::blind::drives {
namespace {

using recording::InertialUnit;
using recording::Instrument;
using recording::Instruments;
using world::addNoise;
using world::apply;
using world::drawnDifference;
using world::enginePhase;
using world::InstrumentSheet;
using world::instrumentSheets;
using world::pushingOf;
using world::seedOf;
using world::Truth;
using world::wandering;

constexpr double kVibration = 8, kVibrationSpread = 0.5;  // Hz
constexpr std::string_view kSensor = "sensor.";
enum Stream : std::uint64_t {
    start_stream,
    noise_stream,
    disturbance_stream,
    vibration_stream,
    difference_stream,
    misreading_stream
};

bool isAccelerometer(std::string_view channel) {
    return channel == "chassis.ax" || channel == "chassis.ay";
}

SensorParams sensorOf(const InstrumentSheet& sheet, const Truth& truth, bool noise, int seed) {
    const Instruments& instruments = truth.car.instruments;
    const Instrument& read = instruments.*sheet.instrument;
    const InertialUnit& unit = instruments.inertial_unit;
    SensorParams sensor;
    sensor.channel = sheet.channel;
    sensor.gain = read.gain;
    sensor.bias = read.bias;
    sensor.delay = std::max(read.delay, 0.0);
    sensor.noise = noise ? sheet.noise : 0;
    sensor.seed = seed;
    if (const auto slow = truth.low_pass.find(sheet.channel); slow != truth.low_pass.end())
        sensor.low_pass = slow->second;
    if (isAccelerometer(sheet.channel)) {
        sensor.position = {unit.x, unit.y, unit.z};
        sensor.misalignment = {.roll = unit.roll, .pitch = unit.pitch};
    }
    return sensor;
}

// Two more sensors in the place of one: level and fixed to the body, without noise and bias.
constexpr std::string_view kLevel = "level ", kFixed = "fixed ";
void addBothWays(SensorParams sensor, std::vector<SensorParams>& sensors) {
    sensor.noise = sensor.bias = 0;
    sensor.name = std::string(kLevel) + sensor.channel;
    sensors.push_back(sensor);
    sensor.name = std::string(kFixed) + sensor.channel;
    sensor.fixed_to_body = true;
    sensors.push_back(sensor);
}

// Adds to each accelerometer the share of the gravity that it reads where the body rolls and pitches, and removes the
// sensors that tell it.
void addGravity(Log& log, double share) {
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        const Channel* level = log.find(std::string(kLevel) + std::string(sheet.channel));
        const Channel* fixed = log.find(std::string(kFixed) + std::string(sheet.channel));
        if (!level || !fixed) continue;
        const auto reading = std::find_if(log.channels.begin(), log.channels.end(),
                                          [&](const Channel& channel) { return channel.name == sheet.channel; });
        for (std::size_t i = 0; i < reading->values.size(); ++i)
            reading->values[i] += share * (fixed->values[i] - level->values[i]);
    }
    std::erase_if(log.channels, [](const Channel& channel) {
        return channel.name.starts_with(kLevel) || channel.name.starts_with(kFixed);
    });
}

// The true car with the differences of this drive.
Truth inThisDrive(Truth truth, std::uint64_t seed, const Conditions& conditions) {
    if (!truth.own || !conditions.surroundings) return truth;
    Random random(seedOf(seed, difference_stream));
    apply(drawnDifference(truth.own->ground, random), truth.car);
    return truth;
}

Scenario scenarioOf(const Truth& truth, const Drive& drive, std::uint64_t seed, const Conditions& conditions) {
    Scenario scenario = drive.scenario;
    Random start(seedOf(seed, start_stream));
    scenario.start.speed *= 1 + conditions.speed_scatter * start.normal();
    scenario.step = scenario.substep = conditions.step;
    scenario.road = truth.car.road;
    scenario.wind = truth.car.wind;
    scenario.log.rate = 100;
    scenario.log.channels = {"driveline.gear"};
    scenario.log.channels.emplace_back(kEngineSpeed);
    const int noise_seed = static_cast<int>(seedOf(seed, noise_stream) >> 34);
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        const SensorParams sensor = sensorOf(sheet, truth, conditions.noise && !truth.own, noise_seed);
        scenario.log.sensors.push_back(sensor);
        if (isAccelerometer(sheet.channel) && truth.car.instruments.inertial_unit.fixed_to_body > 0)
            addBothWays(sensor, scenario.log.sensors);
    }
    return scenario;
}

// Disturbance or surroundings, plus the force of an outsider.
Pushing pushing(const Truth& truth, const Conditions& conditions, std::uint64_t seed) {
    const bool still = truth.own && !conditions.surroundings;
    Pushing first = !truth.own ? wandering(conditions.disturbance, conditions.step, seed)
                    : still    ? pushingOf({}, seed)
                               : pushingOf(truth.own->surroundings, seed);
    if (!truth.push) return first;
    return [first, second = truth.push()](double time, const VehicleInput& driver, const VehicleOutput& car) {
        Push sum = first(time, driver, car);
        const Push more = second(time, driver, car);
        sum.force += more.force;
        sum.moment += more.moment;
        return sum;
    };
}

}  // namespace

void vibrate(Log& log, std::uint64_t seed) {
    Random random(seed);
    const double frequency = kVibration + kVibrationSpread * (2 * random.uniform() - 1);
    const std::vector<double>& time = log.channels.front().values;
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        const double phase = 2 * std::numbers::pi * random.uniform();
        const auto shaken = std::find_if(log.channels.begin(), log.channels.end(),
                                         [&](const Channel& channel) { return channel.name == sheet.channel; });
        if (shaken == log.channels.end() || sheet.vibration == 0) continue;
        for (std::size_t i = 0; i < time.size(); ++i)
            shaken->values[i] += sheet.vibration * std::sin(2 * std::numbers::pi * frequency * time[i] + phase);
    }
}

Log readingsOf(const Truth& truth, const Drive& drive, std::uint64_t seed, const Conditions& conditions) {
    const Truth now = inThisDrive(truth, seed, conditions);
    Log log;
    simulate(now.car.vehicle, scenarioOf(now, drive, seed, conditions), recorderInto(log),
             pushing(now, conditions, seedOf(seed, disturbance_stream)));
    for (Channel& channel : log.channels) {
        if (channel.name.starts_with(kSensor)) channel.name.erase(0, kSensor.size());
    }
    addGravity(log, now.car.instruments.inertial_unit.fixed_to_body);
    Random misreading(seedOf(seed, misreading_stream));
    if (now.misread) now.misread(log, misreading);
    return log;
}

Log measure(const Truth& truth, const Drive& drive, std::uint64_t seed, const Conditions& conditions) {
    Log log = readingsOf(truth, drive, seed, conditions);
    const auto engine = std::find_if(log.channels.begin(), log.channels.end(),
                                     [](const Channel& channel) { return channel.name == kEngineSpeed; });
    const std::vector<double> phase = enginePhase(log.channels.front().values, engine->values);
    log.channels.erase(engine);
    if (!conditions.noise) return log;
    if (truth.own) addNoise(log, truth.own->noise, phase, seedOf(seed, noise_stream));
    else vibrate(log, seedOf(seed, vibration_stream));
    return log;
}

}  // namespace tread::blind::drives
