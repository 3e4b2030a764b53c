// Readings that leave the signal for less time than a body or a hand takes to move there and back.
#pragma once

#include <cstddef>
#include <vector>

#include "import/spikes.h"

namespace tread::recording {

// Little is lost where a reading is taken for a spike and is none, so the limits are lower than those of an import,
// whose result is kept: 6 robust standard deviations of the change per sample, of any height.
inline constexpr SpikeCriterion kShortSpike{.limit = 6, .least = 0, .within = kThereAndBack};

// Interpolates them; returns the samples.
inline std::vector<std::size_t> replaceShortSpikes(const std::vector<double>& time, std::vector<double>& values) {
    return replaceSpikes(time, values, kShortSpike);
}

}  // namespace tread::recording
