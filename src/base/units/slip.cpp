#include "base/units/slip.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "base/text/trimmed.h"
#include "base/units/units.h"

namespace tread {
namespace {

// The units in which people think of a quantity, the likeliest first.
struct Habit {
    std::string_view si;
    std::array<std::string_view, 4> others;
};
constexpr Habit kHabits[] = {
    {"m", {"mm", "cm", "in", "km"}},
    {"kg", {"t", "lb"}},
    {"kg m2", {"kg cm2", "kg mm2"}},
    {"s", {"ms", "min"}},
    {"1/s", {"rpm"}},
    {"m/s", {"km/h", "mph"}},
    {"m/s2", {"g"}},
    {"rad", {"deg"}},
    {"rad/s", {"rpm", "deg/s"}},
    {"rad/m", {"deg/m"}},
    {"rad/N", {"deg/kN", "deg/N"}},
    {"rad/(N m)", {"deg/(N m)", "deg/(kN m)"}},
    {"rad s2/m", {"deg s2/m", "deg/g"}},
    {"m/N", {"mm/kN", "mm/N"}},
    {"N", {"kN", "kgf"}},
    {"N/m", {"N/mm", "kN/m"}},
    {"N/m2", {"N/mm2"}},
    {"N s/m", {"N s/mm", "kN s/m"}},
    {"N m", {"kN m"}},
    {"N m/rad", {"N m/deg", "kN m/rad"}},
    {"N m s/rad", {"N m s/deg"}},
    {"Pa", {"bar", "kPa", "MPa", "psi"}},
    {"Pa/s", {"bar/s", "kPa/s", "MPa/s"}},
    {"W", {"kW", "hp"}},
    {"K", {"degC"}},
    {"J/K", {"kJ/K"}},
    {"-", {"%"}},
};

struct Written {
    std::string number;
    double value;
    std::string unit;  // empty: a bare number
};

std::optional<Written> takenApart(std::string_view written) {
    const std::string_view all = trimmed(written);
    std::string_view rest = all;
    const auto value = takeNumber(rest);
    if (!value) return {};
    return Written{std::string(all.substr(0, all.size() - rest.size())), *value, std::string(trimmed(rest))};
}

bool fits(double value, const Usual& usual) {
    return value != 0 && std::isfinite(value) && usual.has(value);
}

bool fits(const std::string& text, std::string_view unit, const Usual& usual) {
    std::string fault;
    const auto value = toSi(text, unit, fault);
    return value && fits(*value, usual);
}

// "16.8" for 0.0595: to as many digits as a ratio has.
std::string inverse(double value) {
    const double digits = std::pow(10, 2 - std::floor(std::log10(std::abs(1 / value))));
    return numberText(std::round(digits / value) / digits);
}

}  // namespace

std::string likelySlip(std::string_view written, std::string_view unit, const Usual& usual) {
    const auto given = takenApart(written);
    if (!given || given->value == 0) return {};
    for (const Habit& habit : kHabits) {
        if (habit.si != unit) continue;
        for (const std::string_view other : habit.others) {
            if (other.empty() || other == given->unit) continue;
            const std::string meant = concat({given->number, " ", other});
            if (fits(meant, unit, usual)) return "\"" + meant + "\"";
        }
    }
    if (unit.empty() || unit == "-") {
        if (given->unit.empty() && fits(1 / given->value, usual)) return "the inverse, " + inverse(given->value);
        if (given->unit.empty()) return {};
    }
    const bool converted = !given->unit.empty() && given->unit != unit;
    if (converted && fits(given->value, usual)) return concat({"\"", given->number, " ", unit, "\""});
    constexpr double kGram = 1e-3;  // kg; a file cannot say it, its g is standard gravity
    if (unit == "kg" && !converted && fits(kGram * given->value, usual))
        return numberText(kGram * given->value) + " kg, if the value is in g";
    return {};
}

}  // namespace tread
