// Driving and measuring a car of the other simulator.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "blind/measure.h"
#include "blind/other_truth.h"

namespace other_car {

inline constexpr double kStep = 0.002;  // s, of the simulation
inline constexpr int kRowSteps = 5;     // a row every so many steps

// Channels and rows as those of tread::measure.
tread::Log measure(const Truth& truth, const tread::Drive& drive, std::uint64_t seed,
                   const tread::Conditions& conditions = {});

// What is recorded of the driver, step by step.
using Recorded = std::vector<Input>;

// The same without noise: with the inputs that `recorded` shows, if there are any, and pushed by `push`.
struct Replay {
    const Recorded* recorded = nullptr;
    tread::Pushing push = {};
    double faster = 0;  // at the start, as a fraction of the speed
};
struct Replayed {
    tread::Log log;
    Recorded recorded;
};
Replayed replay(const Truth& truth, const tread::Drive& drive, const Replay& how = {});

}  // namespace other_car
