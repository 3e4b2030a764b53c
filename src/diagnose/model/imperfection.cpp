#include "diagnose/model/imperfection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text/pattern.h"
#include "diagnose/settings.h"

namespace tread::diagnose::model {
namespace {

constexpr double kLongestStep = 1;  // of the logarithm of a size

// Of the prior of the logarithms: of each about the common one, and of that about the usual one.
constexpr double kWeight = 1 / (kSettings.part_spread * kSettings.part_spread);
constexpr double kWeightOfCommon = 1 / (kSettings.imperfection_spread * kSettings.imperfection_spread);

// Logarithm of the likeliest common size of some parts.
double logCommon(const Imperfection& sizes, const std::array<bool, kParts>& of) {
    double weights = kWeightOfCommon, sum = weights * std::log(kSettings.imperfection);
    for (std::size_t k = 0; k < kParts; ++k)
        if (of[k]) sum += kWeight * std::log(sizes[k]), weights += kWeight;
    return sum / weights;
}

}  // namespace

Part partOf(std::string_view path) {
    // The first pattern that fits counts.
    static constexpr std::array<std::pair<std::string_view, Part>, 15> kPatterns{{
        {"instruments.*", Part::instruments},
        {"road.*", Part::surroundings},
        {"wind.*", Part::surroundings},
        {"steering.*", Part::steering},
        {"brakes.*", Part::drive},
        {"*.brake_drag", Part::drive},
        {"driveline.*", Part::drive},
        {"*.suspension.*", Part::suspension},
        {"*.unsprung_mass", Part::suspension},
        {"*.tyre*", Part::tyre},
        {"*.wheel_inertia", Part::tyre},
        {"*.grip", Part::tyre},
        {"*.cornering_stiffness", Part::tyre},
        {"*.slip_stiffness", Part::tyre},
        {"*", Part::body},
    }};
    return std::find_if(kPatterns.begin(), kPatterns.end(), [&](const auto& one) { return matches(one.first, path); })
        ->second;
}

Imperfection usualImperfection() {
    Imperfection usual;
    usual.fill(kSettings.imperfection);
    return usual;
}

double logPrior(const Imperfection& sizes) {
    std::array<bool, kParts> all;
    all.fill(true);
    const double common = logCommon(sizes, all), off = common - std::log(kSettings.imperfection);
    double squares = kWeightOfCommon * off * off;
    for (const double size : sizes) squares += kWeight * std::pow(std::log(size) - common, 2);
    return -0.5 * squares;
}

Imperfection improved(Imperfection sizes, const ImperfectionsLeft& left) {
    // The common size, which is the likeliest one, follows each of them: the curvature of the prior is that of each
    // about a constant one, less what they share.
    const double common = logCommon(sizes, left.present);
    std::array<double, kParts> slope{}, curvature{};
    double weights = kWeightOfCommon, sum = 0, shared = 0;
    for (std::size_t k = 0; k < kParts; ++k) {
        if (!left.present[k]) continue;
        slope[k] = left.squares[k] - left.determined[k] - kWeight * (std::log(sizes[k]) - common);
        curvature[k] = left.squares[k] + left.determined[k] + kWeight;
        weights += kWeight, sum += slope[k] / curvature[k], shared += kWeight / curvature[k];
    }
    const double together = kWeight * sum / (weights - kWeight * shared);
    for (std::size_t k = 0; k < kParts; ++k) {
        if (!left.present[k]) continue;
        const double step = (slope[k] + kWeight * together) / curvature[k];
        sizes[k] = std::min(sizes[k] * std::exp(std::clamp(step, -kLongestStep, kLongestStep)),
                            kSettings.largest_imperfection);
    }
    const double now = std::exp(logCommon(sizes, left.present));
    for (std::size_t k = 0; k < kParts; ++k)
        if (!left.present[k]) sizes[k] = now;
    return sizes;
}

double changeOf(const Imperfection& from, const Imperfection& to) {
    double largest = 0;
    for (std::size_t k = 0; k < kParts; ++k) largest = std::max(largest, std::abs(std::log(to[k] / from[k])));
    return largest;
}

}  // namespace tread::diagnose::model
