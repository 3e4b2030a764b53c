// The metrics of a manoeuvre, one line each: the one place that says their names, units, definitions and words, and how
// their values follow from what was found in a log.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/concat.h"
#include "metrics/metric.h"

namespace tread {

// "yaw rate", "overshoot" -> "Yaw rate, overshoot".
inline std::string titleOf(std::string_view quantity, std::string_view feature) {
    std::string title = concat({quantity, ", ", feature});
    if (title.front() >= 'a' && title.front() <= 'z') title.front() = static_cast<char>(title.front() - 'a' + 'A');
    return title;
}

// "front_left" -> "front left".
inline std::string inWords(std::string_view name) {
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

template <class Found>
struct MetricLine {
    MetricDefinition about;
    std::function<double(const Found&)> value;  // in the unit of the definition; NaN: undefined
};

template <class Found>
using MetricTable = std::vector<MetricLine<Found>>;

template <class Found>
std::vector<MetricDefinition> definitions(const MetricTable<Found>& table) {
    std::vector<MetricDefinition> out;
    for (const MetricLine<Found>& line : table) out.push_back(line.about);
    return out;
}

template <class Found>
std::vector<Metric> values(const MetricTable<Found>& table, const Found& found) {
    std::vector<Metric> out;
    for (const auto& [about, value] : table)
        out.push_back({about.name, value(found), about.unit, about.definition, about.say, about.title, about.standard});
    return out;
}

}  // namespace tread
