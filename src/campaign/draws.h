// Points in the unit cube: pure functions of seed, sample and dimension, so that any run can be made again on its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "campaign/campaign_file.h"

namespace tread::campaign {

// Dimensions that the Sobol sequence has here.
inline constexpr std::size_t kSobolDimensions = 40;

// Coordinate of a point of the Sobol sequence (Sobol 1967, in the natural order of Bratley & Fox 1988, direction
// numbers of Joe & Kuo 2008) as a fraction of 2^32; sample 0 is 0.
std::uint32_t sobolPoint(std::uint32_t sample, std::size_t dimension);

// A number that looks random and depends on all three alone (SplitMix64 of Steele, Lea & Flood 2014, chained).
std::uint64_t hashOf(std::uint64_t seed, std::uint64_t a, std::uint64_t b);

// Quantile of the normal distribution of mean 0 and standard deviation 1; `share` above 0 and below 1.
double normalQuantile(double share);
// The other way round.
double normalShare(double value);

// Samples in the unit cube.
class Draws {
public:
    Draws(Sampling sampling, std::uint64_t seed, std::size_t samples, std::size_t dimensions);

    // Above 0 and below 1.
    double at(std::size_t sample, std::size_t dimension) const;

private:
    Sampling sampling_;
    std::uint64_t seed_;
    std::size_t samples_;
    std::vector<std::vector<std::uint32_t>> strata_;  // of a Latin hypercube: stratum of each sample, by dimension
};

}  // namespace tread::campaign
