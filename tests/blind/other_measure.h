// Drives a car of the other simulator and computes the readings of its instruments.
#pragma once

#include <cstdint>
#include <vector>

#include "blind/drives/drives.h"
#include "blind/other_truth.h"
#include "blind/world/reading_noise.h"
#include "blind/world/surroundings.h"
#include "recording/diagnosis_file.h"

namespace other_car {

inline constexpr double kStep = 0.002;  // s, of the simulation
inline constexpr int kRowSteps = 5;     // steps per row of a log

// Surroundings and instruments that all drives of one case share, before and after the fault.
struct ProvingGround {
    std::vector<tread::blind::world::PushSource> surroundings;
    std::vector<tread::blind::world::ReadingNoise> noise;  // in the order of world::instrumentSheets()
};
ProvingGround drawnGround(const tread::VehicleParams& nominal, tread::Random& random);

// Log with the channels and rows of drives::measure. Throws SimulationError.
tread::Log measure(const Truth& truth, const ProvingGround& ground, const tread::blind::drives::Drive& drive,
                   std::uint64_t seed);

// Recorded driver inputs of each step.
using Recorded = std::vector<Input>;

// A drive without noise and surroundings.
struct Replay {
    const Recorded* recorded = nullptr;  // driver inputs to repeat; null: those of the drive
    tread::Pushing push = {};
    double faster = 0;             // relative change of the initial speed
    std::uint64_t misreading = 0;  // seed of Truth::misread
};
struct Replayed {
    tread::Log log;
    Recorded recorded;
    std::vector<double> engine_speed;  // rad/s, of each row
};
Replayed replay(const Truth& truth, const tread::blind::drives::Drive& drive, const Replay& how = {});

}  // namespace other_car
