// Sizes of a remainder of two kinds by brute force: a grid over their logarithms, then ever finer ones about the best
// point.
#pragma once

#include <algorithm>
#include <cmath>

#include "diagnose/model/remainder.h"

namespace tread::linear_drives {

constexpr double kLeastSize = 0.03;  // least of all sizes

// The maximum of a log density and the prior of sizes; the other kinds have size 1.
template <class LogDensity>
diagnose::model::Sizes mostProbableSizes(LogDensity&& log_density, diagnose::model::Disturbed first,
                                         diagnose::model::Disturbed second, const diagnose::model::SizesPrior& prior) {
    constexpr double kCoarse = 0.8, kFine = 0.002;  // of the logarithm
    constexpr int kReach = 5;                       // points of a grid on either side
    const auto pull = [&](double log_size) {
        return log_size < 0 && prior.above_only ? 0 : 0.5 * std::pow(log_size / prior.spread, 2);
    };
    diagnose::model::Sizes best;
    best.fill(1);
    double most = log_density(best);
    for (double step = kCoarse; step > kFine; step /= 2) {
        const double a = std::log(best[placeOf(first)]), b = std::log(best[placeOf(second)]);
        for (int i = -kReach; i <= kReach; ++i) {
            for (int j = -kReach; j <= kReach; ++j) {
                const double log_a = std::max(std::log(kLeastSize), a + i * step),
                             log_b = std::max(std::log(kLeastSize), b + j * step);
                diagnose::model::Sizes sizes = best;
                sizes[placeOf(first)] = std::exp(log_a), sizes[placeOf(second)] = std::exp(log_b);
                const double now = log_density(sizes) - pull(log_a) - pull(log_b);
                if (now > most) most = now, best = sizes;
            }
        }
    }
    return best;
}

}  // namespace tread::linear_drives
