// Driving and measuring a car of the other simulator.
#pragma once

#include <cstdint>

#include "blind/measure.h"
#include "blind/other_truth.h"

namespace other_car {

// Channels and rows as those of tread::measure.
tread::Log measure(const Truth& truth, const tread::Drive& drive, std::uint64_t seed,
                   const tread::Conditions& conditions = {});

}  // namespace other_car
