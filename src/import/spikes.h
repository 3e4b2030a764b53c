// Values of one channel that cannot be: spikes and holes.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace tread {

inline constexpr double kThereAndBack = 0.05;  // s: no body or hand moves there and back within

// What a channel can do.
struct SpikeCriterion {
    double limit = 12;                                         // robust standard deviations of the change per sample
    double fastest = std::numeric_limits<double>::infinity();  // largest rate of change of the car, unit per second
    double longest = std::numeric_limits<double>::infinity();  // s: longer spikes become NaN, as nothing was measured
    double largest = std::numeric_limits<double>::infinity();  // magnitude that a road vehicle reaches
    double least = 0.1;                                        // height of a short spike, share of the 1-99 % range
    double within = std::numeric_limits<double>::infinity();   // s: length of a short spike, from and to good samples
};

// Replaces two kinds of spikes by what lies between their neighbours.
//
// Of any length: the channel jumps by more than `fastest` allows within one sample (within the time for which its
// values are held, when it is updated less often than it is logged) and its noise, `limit` robust standard deviations
// of the change per sample; later it jumps back by as much, to less than half the first jump from where it was. A
// plateau that begins or ends at a rate that the car can reach is no spike, whatever its height. No more than half the
// samples.
//
// Of one to three samples: the channel leaves by more than `limit` robust standard deviations of its change per sample
// (from the 90 % quantile of its magnitude over the 100 samples around, so that quantised and lively channels keep
// their own) and by more than the share `least` of its range, and comes back `within` so long. With a known `fastest`
// only within kThereAndBack. Channels with no more than 16 different values (gear, switches) are left alone.
//
// Returns the samples that were replaced, in order.
std::vector<std::size_t> replaceSpikes(const std::vector<double>& time, std::vector<double>& values,
                                       const SpikeCriterion& criterion);
inline std::vector<std::size_t> replaceSpikes(const std::vector<double>& time, std::vector<double>& values,
                                              double limit) {
    return replaceSpikes(time, values, SpikeCriterion{.limit = limit});
}

// Interpolates runs of NaN between two values that are no more than `longest` apart in time; returns how many samples.
std::size_t fillHoles(const std::vector<double>& time, std::vector<double>& values, double longest);

}  // namespace tread
