// What a case draws its numbers with.
#pragma once

#include <cstdint>

#include "base/random.h"

namespace tread {

// Seed of the nth of something that has a seed itself.
std::uint64_t seedOf(std::uint64_t seed, std::uint64_t n);

double between(Random& random, double low, double high);
// Each factor is as likely as its like: uniform in the logarithm.
double betweenFactors(Random& random, double low, double high);
double eitherSign(Random& random);  // -1 or 1

// Student's t with four degrees of freedom, scaled to a standard deviation of 1 and held within four of them: one in a
// hundred lies beyond 3.3 (of a normal distribution beyond 2.6), one in two hundred at the bound.
double heavyTailed(Random& random);

}  // namespace tread
