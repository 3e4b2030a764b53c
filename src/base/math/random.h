// Random numbers that are the same on every machine: the standard fixes the engine, but not its distributions.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "base/math/elementary.h"
#include "base/math/power.h"

namespace tread {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    // In [0, 1).
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    // Of mean 0 and standard deviation 1 (Box and Muller, 1958).
    double normal() {
        const double radius = std::sqrt(-2 * logarithm(1 - uniform()));
        return radius * cosine(2 * std::numbers::pi * uniform());
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace tread
