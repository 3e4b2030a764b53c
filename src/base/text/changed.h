// A name that says what was changed of what it names: "Step steer at 80 km/h [changed: start.speed 80 mph (was 80
// km/h)]". The scenario's title and the car's name carry it, so that every page, answer and file that shows them tells
// the truth, also of a run that is repeated from its resolved inputs.
#pragma once

#include <string>
#include <string_view>

namespace tread {

inline constexpr std::string_view kChanged = " [changed: ";

struct ChangedName {
    std::string name;
    std::string changes;  // without the words before; empty: none
};

inline ChangedName splitChanged(std::string_view whole) {
    const std::size_t at = whole.find(kChanged);
    if (at == std::string_view::npos || !whole.ends_with(']')) return {std::string(whole), ""};
    const std::size_t from = at + kChanged.size();
    return {std::string(whole.substr(0, at)), std::string(whole.substr(from, whole.size() - 1 - from))};
}

// A name without words stays so: it states nothing that could be wrong.
inline std::string withChange(const std::string& whole, std::string_view change) {
    if (whole.empty()) return whole;
    auto [name, changes] = splitChanged(whole);
    changes += changes.empty() ? "" : ", ";
    changes += change;
    return name.append(kChanged).append(changes) + "]";
}

}  // namespace tread
