// The instruments of the cars of a blind check, and the noise of their readings.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/math/random.h"
#include "blind/world/reading_noise.h"
#include "log/log.h"
#include "recording/instruments.h"

namespace tread::blind::world {

// Data sheet of the instrument of one channel. Units are those of the channel.
struct InstrumentSheet {
    std::string_view channel;
    recording::Instrument recording::Instruments::*instrument;
    double noise;       // standard deviation of one reading
    double vibration;   // amplitude at about 8 Hz, excited by engine and road
    double resolution;  // quantisation step
};

const std::vector<InstrumentSheet>& instrumentSheets();

// Whether it records an input of the driver, not the motion of the car.
bool measuresDriver(const InstrumentSheet& sheet);

// In the order of instrumentSheets(). World::assumed: white noise of the data sheets and the same vibration in all
// cars.
std::vector<ReadingNoise> assumedNoise();
// World::own: noise of each instrument drawn about its data sheet.
std::vector<ReadingNoise> drawnNoise(Random& random);

// Phase (rad) of the engine order that excites vibration. `engine_speed`: rad/s at `times` (s).
std::vector<double> enginePhase(std::span<const double> times, std::span<const double> engine_speed);

// Adds coloured noise, vibration, jitter, quantisation and spikes to the channels of all instruments.
void addNoise(Log& log, const std::vector<ReadingNoise>& noises, std::span<const double> engine_phase,
              std::uint64_t seed);

}  // namespace tread::blind::world
