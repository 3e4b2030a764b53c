// Random draws of the cases: derived seeds and the distributions that recur.
#pragma once

#include <cstdint>

#include "base/math/random.h"

namespace tread::blind::world {

// Seed number n derived from another seed.
std::uint64_t seedOf(std::uint64_t seed, std::uint64_t n);

double between(Random& random, double low, double high);
// Log-uniform.
double betweenFactors(Random& random, double low, double high);
double eitherSign(Random& random);  // -1 or 1

// Student's t with four degrees of freedom, scaled to a standard deviation of 1 and clamped to +-4: one draw in a
// hundred lies beyond 3.3 (normal distribution: 2.6), one in two hundred at the bound.
double heavyTailed(Random& random);

}  // namespace tread::blind::world
