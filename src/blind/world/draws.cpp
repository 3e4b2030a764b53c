#include "blind/world/draws.h"

#include <algorithm>
#include <cmath>

namespace tread::blind::world {

std::uint64_t seedOf(std::uint64_t seed, std::uint64_t n) {
    // SplitMix64 (Steele, Lea, Flood, 2014).
    std::uint64_t z = seed + (n + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double between(Random& random, double low, double high) {
    return low + (high - low) * random.uniform();
}

double betweenFactors(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

double eitherSign(Random& random) {
    return random.uniform() < 0.5 ? -1 : 1;
}

double heavyTailed(Random& random) {
    constexpr double kBound = 4;
    // Student's t with four degrees of freedom has the variance 2.
    const double normal = random.normal();
    double squares = 0;
    for (int i = 0; i < 4; ++i) {
        const double one = random.normal();
        squares += one * one;
    }
    return std::clamp(normal / std::sqrt(squares / 4) / std::sqrt(2.0), -kBound, kBound);
}

}  // namespace tread::blind::world
