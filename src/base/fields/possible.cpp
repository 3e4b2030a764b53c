#include "base/fields/possible.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "base/units/slip.h"

namespace tread {
namespace {

// Beyond every unit that is mistaken for its neighbour (mm for m, g for kg), and beyond every toy, truck and rig.
constexpr double kBeyond = 1000;

struct Sizes {
    double smallest = 0;
    double largest = kInfinity;
};

// To three digits: a thousandth of a number has more of them than it is worth.
double threeDigits(double value) {
    if (!std::isfinite(value)) return value;
    std::array<char, 32> text;
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 2);
    std::from_chars(text.data(), written.ptr, value);
    return value;
}

Sizes possibleSizes(const Usual& usual) {
    if (!usual.said) return {};
    const double one = std::abs(usual.lowest), other = std::abs(usual.highest);
    const bool reaches_zero = usual.lowest <= 0 && usual.highest >= 0;
    return {reaches_zero ? 0 : threeDigits(std::min(one, other) / kBeyond),
            threeDigits(std::max(one, other) * kBeyond)};
}

std::string sizesText(const Sizes& sizes) {
    if (!std::isfinite(sizes.largest)) return concat({"of at least ", numberText(sizes.smallest), " in size"});
    if (sizes.smallest == 0) return concat({"of at most ", numberText(sizes.largest), " in size"});
    return concat({"between ", numberText(sizes.smallest), " and ", numberText(sizes.largest), " in size"});
}

}  // namespace

bool isPossible(const Usual& usual, double value) {
    if (value == 0 || !std::isfinite(value)) return true;
    const Sizes sizes = possibleSizes(usual);
    return std::abs(value) >= sizes.smallest && std::abs(value) <= sizes.largest;
}

std::string impossibleText(double value, std::string_view written, std::string_view unit, const Usual& usual) {
    const std::string given = written.empty() ? numberText(value) : std::string(written);
    const std::string in = unit.empty() || unit == "-" ? "" : concat({"in ", unit, " "});
    const std::string slip = likelySlip(given, unit, usual);
    return concat({"found ", quote(given), ", expected a number ", in, sizesText(possibleSizes(usual)),
                   ", within a factor of 1000 of what is plausible",
                   slip.empty() ? "; correct value or unit" : "; did you mean ", slip, slip.empty() ? "" : "?"});
}

Limits possibleLimits(const About& about) {
    const Sizes sizes = possibleSizes(about.usual);
    Limits limits = about.limits;
    if (sizes.largest < limits.highest) limits.highest = sizes.largest, limits.highest_open = false;
    if (-sizes.largest > limits.lowest) limits.lowest = -sizes.largest, limits.lowest_open = false;
    const bool has_zero = about.limits.allow(0);
    if (!has_zero && limits.lowest >= 0 && sizes.smallest > limits.lowest)
        limits.lowest = sizes.smallest, limits.lowest_open = false;
    return limits;
}

}  // namespace tread
