// Values of one channel that cannot be: spikes and holes.
#pragma once

#include <cstddef>
#include <vector>

namespace tread {

// Replaces excursions of one to three samples that leave the channel by more than `limit` robust standard deviations of
// its change per sample (from the 90 % quantile of its magnitude over the 100 samples around, so that quantised and
// lively channels keep their own) and by more than 10 % of its 1-99 % range, and that come back. Channels with no more
// than 16 different values (gear, switches) are left alone. Returns the samples that were replaced.
std::vector<std::size_t> replaceSpikes(const std::vector<double>& time, std::vector<double>& values, double limit);

// Interpolates runs of NaN between two values that are no more than `longest` apart in time; returns how many samples.
std::size_t fillHoles(const std::vector<double>& time, std::vector<double>& values, double longest);

}  // namespace tread
