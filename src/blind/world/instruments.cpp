#include "blind/world/instruments.h"
#include "recording/instruments.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "blind/world/draws.h"

namespace tread::blind::world {
namespace {

constexpr double kVibration = 8, kVibrationBand = 0.5;  // Hz
constexpr double kEngineOrder = 2;                      // firing order of a four-stroke engine with four cylinders

// Guesses: good instruments that deviate somewhat from their data sheets.
constexpr double kLeastLevel = 0.5, kMostLevel = 2;  // factors of the noise and the vibration of the data sheet
constexpr double kMostCorrelation = 0.6;             // of errors 10 ms apart
constexpr double kEngineShare = 0.5;                 // of the amplitude at 8 Hz
constexpr double kEngineScatter = 0.005;             // as drives::kSpeedScatter: wheels and engine turn in proportion
constexpr double kJitter = 0.001;                    // s: sensor and bus are not synchronised
constexpr double kSpikes = 1e-4,
                 kSpikeHeight = 40;  // probability per reading; standard deviation over that of the noise

// Value `samples` (a fraction, of either sign) after sample i, by linear interpolation.
double shifted(const std::vector<double>& values, std::size_t i, double samples) {
    const double place = std::clamp(static_cast<double>(i) + samples, 0.0, static_cast<double>(values.size() - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

void spoil(std::vector<double>& values, const ReadingNoise& noise, std::span<const double> times,
           std::span<const double> engine_phase, Random& random) {
    const double interval = times.size() > 1 ? times[1] - times[0] : 1;
    const double frequency = noise.frequency + noise.frequency_band * (2 * random.uniform() - 1);
    const double road = 2 * std::numbers::pi * random.uniform(), engine = 2 * std::numbers::pi * random.uniform();
    const double fresh = std::sqrt(1 - noise.correlation * noise.correlation);
    const std::vector<double> clean = values;
    double error = noise.level * random.normal();
    for (std::size_t i = 0; i < values.size(); ++i) {
        double shown = noise.jitter > 0 ? shifted(clean, i, random.normal() * noise.jitter / interval) : clean[i];
        shown += error + noise.shaking * std::sin(2 * std::numbers::pi * frequency * times[i] + road);
        if (!engine_phase.empty()) shown += noise.engine * std::sin(engine_phase[i] + engine);
        if (noise.spikes > 0 && random.uniform() < noise.spikes) shown += noise.spike_height * random.normal();
        values[i] = noise.resolution > 0 ? noise.resolution * std::round(shown / noise.resolution) : shown;
        error = noise.correlation * error + fresh * noise.level * random.normal();
    }
}

}  // namespace

using recording::Instruments;

const std::vector<InstrumentSheet>& instrumentSheets() {
    // Guesses: a good inertial unit, an optical speed sensor, and the wheel speeds of the car's own control unit.
    static const std::vector<InstrumentSheet> list{
        {"driver.steering_wheel_angle", &Instruments::steering_wheel_angle, 0.002, 0, 0.0017},
        {"driver.throttle", &Instruments::throttle, 0.001, 0, 0.002},
        {"driver.brake", &Instruments::brake, 0.001, 0, 0.002},
        {"chassis.ax", &Instruments::ax, 0.05, 0.1, 0.01},
        {"chassis.ay", &Instruments::ay, 0.05, 0.15, 0.01},
        {"chassis.yaw_rate", &Instruments::yaw_rate, 0.002, 0.003, 0.0005},
        {"chassis.roll_rate", &Instruments::roll_rate, 0.003, 0.005, 0.0005},
        {"chassis.roll", &Instruments::roll, 0.001, 0, 0.0002},
        {"chassis.vx", &Instruments::speed, 0.03, 0, 0.01},
        {"wheel.front_left.spin", &Instruments::wheel_speed, 0.1, 0, 0.05},
        {"wheel.front_right.spin", &Instruments::wheel_speed, 0.1, 0, 0.05},
        {"wheel.rear_left.spin", &Instruments::wheel_speed, 0.1, 0, 0.05},
        {"wheel.rear_right.spin", &Instruments::wheel_speed, 0.1, 0, 0.05},
    };
    return list;
}

bool measuresDriver(const InstrumentSheet& sheet) {
    return sheet.channel.starts_with("driver.");
}

std::vector<ReadingNoise> assumedNoise() {
    std::vector<ReadingNoise> noises;
    for (const InstrumentSheet& sheet : instrumentSheets())
        noises.push_back({.level = sheet.noise,
                          .shaking = sheet.vibration,
                          .frequency = kVibration,
                          .frequency_band = kVibrationBand});
    return noises;
}

std::vector<ReadingNoise> drawnNoise(Random& random) {
    std::vector<ReadingNoise> noises = assumedNoise();
    std::optional<double> of_the_wheels;  // one unit measures all four
    for (std::size_t i = 0; i < noises.size(); ++i) {
        ReadingNoise& noise = noises[i];
        const InstrumentSheet& sheet = instrumentSheets()[i];
        double level = betweenFactors(random, kLeastLevel, kMostLevel);
        if (sheet.channel.starts_with("wheel.")) {
            of_the_wheels = of_the_wheels.value_or(level);
            level = *of_the_wheels;
        }
        noise.level *= level;
        noise.correlation = kMostCorrelation * random.uniform();
        noise.shaking *= betweenFactors(random, kLeastLevel, kMostLevel);
        noise.engine = kEngineShare * noise.shaking;
        noise.engine_scatter = kEngineScatter;
        noise.resolution = sheet.resolution;
        if (measuresDriver(sheet)) continue;
        noise.jitter = kJitter * random.uniform();
        noise.spikes = kSpikes;
        noise.spike_height = kSpikeHeight * noise.level;
    }
    return noises;
}

std::vector<double> enginePhase(std::span<const double> times, std::span<const double> engine_speed) {
    std::vector<double> phase(times.size());
    for (std::size_t i = 1; i < times.size(); ++i)
        phase[i] =
            phase[i - 1] + kEngineOrder * 0.5 * (engine_speed[i] + engine_speed[i - 1]) * (times[i] - times[i - 1]);
    return phase;
}

void addNoise(Log& log, const std::vector<ReadingNoise>& noises, std::span<const double> engine_phase,
              std::uint64_t seed) {
    const std::vector<double> times = log.channels.front().values;
    for (std::size_t i = 0; i < noises.size(); ++i) {
        Random random(seedOf(seed, i));
        for (Channel& channel : log.channels) {
            if (channel.name == instrumentSheets()[i].channel)
                spoil(channel.values, noises[i], times, engine_phase, random);
        }
    }
}

}  // namespace tread::blind::world
