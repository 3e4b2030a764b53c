// The instruments on board of the car of a blind case, and the noise of their readings.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "blind/reading_noise.h"
#include "diagnose/instruments.h"
#include "log/log.h"

namespace tread {

struct Gauge {
    std::string_view channel;
    Instrument Instruments::*instrument;
    double noise;       // standard deviation of one reading, in the SI unit of the channel, as its data sheet says
    double vibration;   // amplitude of what engine and road shake it with, at about 8 Hz
    double resolution;  // smallest step of a reading
};

const std::vector<Gauge>& gauges();

// Shows what the driver does, not what the car does.
bool isOfTheDriver(const Gauge& gauge);

// World::assumed: white noise as the data sheets say, and the same vibration in all cars; World::own: of each
// instrument as drawn. In the order of gauges().
std::vector<ReadingNoise> assumedNoise();
std::vector<ReadingNoise> drawnNoise(Random& random);

// Phase of the engine's order that shakes the car, over a drive (rad); `engine_speed` in rad/s at these times.
std::vector<double> enginePhase(std::span<const double> times, std::span<const double> engine_speed);

// Adds noise to a log of all gauges: coloured noise, vibration, jitter, steps, spikes.
void addNoise(Log& log, const std::vector<ReadingNoise>& noises, std::span<const double> engine_phase,
              std::uint64_t seed);

}  // namespace tread
