// Imperfections: small errors of the model along every effect that is no cause. Each part of the car, its surroundings
// and the instruments have a size of their own, estimated with each fit (D16b), (D26b).
#pragma once

#include <array>
#include <string_view>

namespace tread::diagnose::model {

enum class Part { tyre, suspension, steering, drive, body, surroundings, instruments };
inline constexpr std::array<std::string_view, 7> kPartNames{"tyres", "suspension",   "steering",   "drive",
                                                            "body",  "surroundings", "instruments"};
inline constexpr std::size_t kParts = kPartNames.size();

// Typical size of the imperfections of each part, as a share of the typical sizes of the effects.
using Imperfection = std::array<double, kParts>;

// Part of the number at a path in Subject.
Part partOf(std::string_view path);

Imperfection usualImperfection();

// Logarithm of the prior density. The logarithms are normal about that of a size common to all parts, and this one
// about the usual size; the common size is the likeliest one.
double logPrior(const Imperfection& sizes);

// What a fit leaves in the imperfections of each part: the sum of their squares, in units of the size, and how many of
// them the data determine. A part with no imperfection has the common size.
struct ImperfectionsLeft {
    std::array<double, kParts> squares{}, determined{};
    std::array<bool, kParts> present{};
};
// Newton's step in the logarithm of each size towards the largest evidence (D26b).
Imperfection improved(Imperfection sizes, const ImperfectionsLeft& left);

// Largest change of the logarithm of a size.
double changeOf(const Imperfection& from, const Imperfection& to);

}  // namespace tread::diagnose::model
