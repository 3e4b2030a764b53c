// Driving and measuring a car of the other simulator.
#pragma once

#include <cstdint>
#include <vector>

#include "blind/drives.h"
#include "blind/other_truth.h"
#include "blind/reading_noise.h"
#include "blind/surroundings.h"
#include "recording/diagnosis_file.h"

namespace other_car {

inline constexpr double kStep = 0.002;  // s, of the simulation
inline constexpr int kRowSteps = 5;     // a row every so many steps

// Where and with what the drives of one case are driven, before and after.
struct ProvingGround {
    std::vector<tread::PushSource> surroundings;
    std::vector<tread::ReadingNoise> noise;  // in the order of gauges()
};
ProvingGround drawnGround(const tread::VehicleParams& nominal, tread::Random& random);

// Channels and rows as those of tread::measure. Throws SimulationError.
tread::Log measure(const Truth& truth, const ProvingGround& ground, const tread::Drive& drive, std::uint64_t seed);

// What is recorded of the driver, step by step.
using Recorded = std::vector<Input>;

// The same without noise and surroundings: with the inputs that `recorded` shows, if there are any, and pushed by
// `push`.
struct Replay {
    const Recorded* recorded = nullptr;
    tread::Pushing push = {};
    double faster = 0;             // at the start, as a fraction of the speed
    std::uint64_t misreading = 0;  // seed of what instruments from outside the catalogue do
};
struct Replayed {
    tread::Log log;
    Recorded recorded;
    std::vector<double> engine_speed;  // rad/s, of each row
};
Replayed replay(const Truth& truth, const tread::Drive& drive, const Replay& how = {});

}  // namespace other_car
