#include "scenario/expression/functions.h"

#include <algorithm>
#include <array>

namespace tread {
namespace {

// Name, arguments, their number, unit, meaning, how many are times, whether it reduces, whether it wants a condition.
constexpr FunctionAbout kFunctions[] = {
    {"abs", Function::abs, "x", 1, 1, UnitOf::same, "magnitude"},
    {"sign", Function::sign, "x", 1, 1, UnitOf::pure, "-1, 0 or 1"},
    {"sqrt", Function::sqrt, "x", 1, 1, UnitOf::root, "square root; undefined below zero"},
    {"sin", Function::sin, "angle", 1, 1, UnitOf::pure, "sine"},
    {"cos", Function::cos, "angle", 1, 1, UnitOf::pure, "cosine"},
    {"tan", Function::tan, "angle", 1, 1, UnitOf::pure, "tangent"},
    {"atan", Function::atan, "x", 1, 1, UnitOf::angle, "angle with this tangent"},
    {"atan2", Function::atan2, "y, x", 2, 2, UnitOf::angle, "angle of the point (x, y)"},
    {"hypot", Function::hypot, "x, y", 2, 2, UnitOf::same, "root of the sum of the squares"},
    {"lower", Function::lower, "x, y", 2, 2, UnitOf::same, "the lower of two values, at each moment"},
    {"higher", Function::higher, "x, y", 2, 2, UnitOf::same, "the higher of two values, at each moment"},
    {"rate", Function::rate, "x", 1, 1, UnitOf::over_time,
     "rate of change: between neighbouring samples of a log, since the step before in a condition of a phase"},
    {"smoothed", Function::smoothed, "x, half_width", 2, 2, UnitOf::same,
     "mean over the half width before and after each moment; in metrics only", 1},
    {"max", Function::max, "x, from, to", 1, 3, UnitOf::same, "largest value", 2, true},
    {"min", Function::min, "x, from, to", 1, 3, UnitOf::same, "least value", 2, true},
    {"mean", Function::mean, "x, from, to", 1, 3, UnitOf::same, "mean over time", 2, true},
    {"rms", Function::rms, "x, from, to", 1, 3, UnitOf::same, "root of the mean square over time", 2, true},
    {"integral", Function::integral, "x, from, to", 1, 3, UnitOf::times_time, "integral over time", 2, true},
    {"first", Function::first, "x, from, to", 1, 3, UnitOf::same, "value at the beginning", 2, true},
    {"last", Function::last, "x, from, to", 1, 3, UnitOf::same, "value at the end", 2, true},
    {"at", Function::at, "x, time", 2, 2, UnitOf::same, "value at a time, linear between samples", 1, true},
    {"time_of", Function::time_of, "condition, from, to", 1, 3, UnitOf::time,
     "first time at which the condition is met; undefined when it never is", 2, true, true},
    {"duration", Function::duration, "condition, from, to", 1, 3, UnitOf::time,
     "time for which the condition is met, altogether", 2, true, true},
    {"longest", Function::longest, "condition, from, to", 1, 3, UnitOf::time,
     "longest time for which the condition is met without a break", 2, true, true},
    {"count", Function::count, "condition, from, to", 1, 3, UnitOf::pure,
     "how many times the condition begins to be met", 2, true, true},
    {"start", Function::start, "phase", 0, 1, UnitOf::time,
     "when a phase began, by its name in quotes or its number from 1; start(): when the log begins"},
    {"end", Function::end, "phase", 0, 1, UnitOf::time, "when a phase ended; end(): when the log ends"},
};

}  // namespace

std::span<const FunctionAbout> functions() {
    return kFunctions;
}

const FunctionAbout* functionNamed(std::string_view name) {
    const auto found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                    [&](const FunctionAbout& about) { return about.name == name; });
    return found == std::end(kFunctions) ? nullptr : &*found;
}

std::string callOf(const FunctionAbout& about) {
    std::string text(about.name);
    std::string_view rest = about.arguments;
    std::string closing;
    text += "(";
    for (std::size_t i = 0; !rest.empty(); ++i) {
        const std::size_t comma = rest.find(", ");
        const bool optional = i >= about.least;
        if (optional) closing += "]";
        text += (optional ? (i > 0 ? " [" : "[") : "") + std::string(i > 0 ? ", " : "");
        text += rest.substr(0, comma);
        rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 2);
    }
    return text + closing + ")";
}

}  // namespace tread
