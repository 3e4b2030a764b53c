// The functions of expressions.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace tread {

enum class Function {
    abs,
    sign,
    sqrt,
    sin,
    cos,
    tan,
    atan,
    atan2,
    hypot,
    lower,
    higher,
    rate,
    smoothed,  // at each moment
    max,
    min,
    mean,
    rms,
    integral,
    first,
    last,
    at,  // one number of a channel
    time_of,
    duration,
    longest,
    count,  // of a condition
    start,
    end  // times of the run
};

// How the unit of a function follows from that of its first argument.
enum class UnitOf { same, pure, angle, root, over_time, times_time, time };

struct FunctionAbout {
    std::string_view name;
    Function function;
    std::string_view arguments;  // "x, from, to"
    std::size_t least, most;     // number of arguments
    UnitOf unit;
    std::string_view meaning;
    std::size_t times = 0;  // the last so many of `most` arguments are times
    bool reduces = false;   // one number from values over time
    bool of_condition = false;
};

std::span<const FunctionAbout> functions();
const FunctionAbout* functionNamed(std::string_view name);  // nullptr: none

// "max(x [, from [, to]])".
std::string callOf(const FunctionAbout& about);

}  // namespace tread
