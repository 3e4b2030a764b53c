#include "campaign/draws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/math/random.h"

namespace tread::campaign {
namespace {

constexpr int kBits = 32;

// A dimension of the Sobol sequence: inner coefficients of its primitive polynomial, as bits, and its first direction
// numbers; their count is the degree.
struct Direction {
    unsigned polynomial;
    std::array<unsigned, 8> first;  // 0: no more
};

// S. Joe and F. Y. Kuo, Constructing Sobol sequences with better two-dimensional projections, SIAM J. Sci. Comput. 30
// (2008): the set new-joe-kuo-6, from its second dimension on.
constexpr std::array<Direction, kSobolDimensions - 1> kDirections{{
    {0, {1}},
    {1, {1, 3}},
    {1, {1, 3, 1}},
    {2, {1, 1, 1}},
    {1, {1, 1, 3, 3}},
    {4, {1, 3, 5, 13}},
    {2, {1, 1, 5, 5, 17}},
    {4, {1, 1, 5, 5, 5}},
    {7, {1, 1, 7, 11, 19}},
    {11, {1, 1, 5, 1, 1}},
    {13, {1, 1, 1, 3, 11}},
    {14, {1, 3, 5, 5, 31}},
    {1, {1, 3, 3, 9, 7, 49}},
    {13, {1, 1, 1, 15, 21, 21}},
    {16, {1, 3, 1, 13, 27, 49}},
    {19, {1, 1, 1, 15, 7, 5}},
    {22, {1, 3, 1, 15, 13, 25}},
    {25, {1, 1, 5, 5, 19, 61}},
    {1, {1, 3, 7, 11, 23, 15, 103}},
    {4, {1, 3, 7, 13, 13, 15, 69}},
    {7, {1, 1, 3, 13, 7, 35, 63}},
    {8, {1, 3, 5, 9, 1, 25, 53}},
    {14, {1, 3, 1, 13, 9, 35, 107}},
    {19, {1, 3, 1, 5, 27, 61, 31}},
    {21, {1, 1, 5, 11, 19, 41, 61}},
    {28, {1, 3, 5, 3, 3, 13, 69}},
    {31, {1, 1, 7, 13, 1, 19, 1}},
    {32, {1, 3, 7, 5, 13, 19, 59}},
    {37, {1, 1, 3, 9, 25, 29, 41}},
    {41, {1, 3, 5, 13, 23, 1, 55}},
    {42, {1, 3, 7, 3, 13, 59, 17}},
    {50, {1, 3, 1, 3, 5, 53, 69}},
    {55, {1, 1, 5, 5, 23, 33, 13}},
    {56, {1, 1, 7, 7, 1, 61, 123}},
    {59, {1, 1, 7, 9, 13, 61, 49}},
    {62, {1, 3, 3, 5, 3, 55, 33}},
    {14, {1, 3, 1, 15, 31, 13, 49, 245}},
    {21, {1, 3, 5, 15, 31, 59, 63, 97}},
    {22, {1, 3, 1, 11, 11, 11, 77, 249}},
}};

using DirectionNumbers = std::array<std::uint32_t, kBits>;

DirectionNumbers directionNumbers(std::size_t dimension) {
    DirectionNumbers v{};
    if (dimension == 0) {
        for (int i = 0; i < kBits; ++i) v[static_cast<std::size_t>(i)] = 1u << (kBits - 1 - i);
        return v;
    }
    const Direction& of = kDirections[dimension - 1];
    std::size_t degree = 0;
    while (degree < of.first.size() && of.first[degree] != 0) ++degree;
    for (std::size_t i = 0; i < kBits; ++i) {
        if (i < degree) {
            v[i] = of.first[i] << (kBits - 1 - i);
            continue;
        }
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for (std::size_t k = 1; k < degree; ++k) {
            if ((of.polynomial >> (degree - 1 - k) & 1u) != 0) v[i] ^= v[i - k];
        }
    }
    return v;
}

const std::array<DirectionNumbers, kSobolDimensions>& allDirections() {
    static const auto kAll = [] {
        std::array<DirectionNumbers, kSobolDimensions> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = directionNumbers(i);
        return all;
    }();
    return kAll;
}

std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

// Of the upper 53 bits, in the middle of its cell: above 0 and below 1.
double unit(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

constexpr std::uint64_t kShuffle = 1, kWithin = 2, kShift = 3;  // streams of one seed

}  // namespace

std::uint32_t sobolPoint(std::uint32_t sample, std::size_t dimension) {
    const DirectionNumbers& v = allDirections().at(dimension);
    std::uint32_t point = 0;
    for (std::size_t i = 0; sample != 0; ++i, sample >>= 1) {
        if ((sample & 1u) != 0) point ^= v[i];
    }
    return point;
}

std::uint64_t hashOf(std::uint64_t seed, std::uint64_t a, std::uint64_t b) {
    return mixed(mixed(mixed(seed) ^ a) ^ b);
}

double normalShare(double value) {
    return 0.5 * std::erfc(-value / std::numbers::sqrt2);
}

// Bisection on the distribution, then Newton: exact to rounding without a table of coefficients.
double normalQuantile(double share) {
    if (share > 0.5) return -normalQuantile(1 - share);
    constexpr double kFarthest = -38;  // standard deviations: the share there is the least double
    double low = kFarthest, high = 0;
    for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (low + high);
        (normalShare(middle) < share ? low : high) = middle;
    }
    double z = 0.5 * (low + high);
    for (int i = 0; i < 3; ++i) {
        const double density = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
        if (density < std::numeric_limits<double>::min()) break;
        z -= (normalShare(z) - share) / density;
    }
    return z;
}

Draws::Draws(Sampling sampling, std::uint64_t seed, std::size_t samples, std::size_t dimensions)
    : sampling_(sampling), seed_(seed), samples_(samples) {
    if (sampling != Sampling::latin_hypercube) return;
    for (std::size_t d = 0; d < dimensions; ++d) {
        std::vector<std::uint32_t> order(samples);
        std::iota(order.begin(), order.end(), 0u);
        Random random(hashOf(seed, kShuffle, d));
        for (std::size_t i = samples; i > 1; --i) {
            const auto j = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
            std::swap(order[i - 1], order[j]);
        }
        strata_.push_back(std::move(order));
    }
}

double Draws::at(std::size_t sample, std::size_t dimension) const {
    switch (sampling_) {
        case Sampling::latin_hypercube:
            return std::min((strata_[dimension][sample] + unit(hashOf(seed_ ^ kWithin, dimension, sample))) /
                                static_cast<double>(samples_),
                            1 - 0x1p-53);
        // Shifted bit by bit: as well spread as the sequence itself, and another set for every seed.
        case Sampling::sobol:
        case Sampling::sobol_indices: {
            const auto shift = static_cast<std::uint32_t>(hashOf(seed_, kShift, dimension) >> 32);
            return (static_cast<double>(sobolPoint(static_cast<std::uint32_t>(sample), dimension) ^ shift) + 0.5) *
                   0x1p-32;
        }
        case Sampling::random:
            break;
    }
    return unit(hashOf(seed_, dimension + 16, sample));
}

}  // namespace tread::campaign
