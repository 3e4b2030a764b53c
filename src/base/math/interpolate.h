// Described structs of numbers, interpolated field by field.
#pragma once

#include <array>
#include <string_view>

#include "tread/describe.h"

namespace tread {

// What lies at `share` (0 to 1) of the way between two. A struct that has something else than doubles does not compile.
template <Described T>
T interpolated(const T& begin, const T& end, double share) {
    std::array<double, detail::describedCount<T>()> targets{};
    std::size_t i = 0;
    T::describe(end, [&](std::string_view, const auto& value, const About&) { targets[i++] = value; });
    T result = begin;
    i = 0;
    T::describe(result,
                [&](std::string_view, double& value, const About&) { value += share * (targets[i++] - value); });
    return result;
}

}  // namespace tread
