// One number that answers a question about a run.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace tread {

// A metric in words, for the one line that sums a run up. That has the first few that are defined.
struct Say {
    int rank = 0;           // what says most has 1; 0: it is not said
    std::string_view text;  // {} stands for the number
    int decimals = 0;       // at most
    double scale = 1;       // from the unit of the metric to that of the text
};

struct MetricDefinition {
    std::string name;        // in files and on the command line
    std::string title;       // for people: what is measured first, "Deceleration, peak"
    std::string unit;        // as the standards quote it: "deg/g", "s deg", "m"
    std::string definition;  // one sentence; says when the metric is not defined
    Say say = {};
    std::string standard = {};  // what the standard asks of it, as a condition ("<= 35 %"); empty: nothing
};

struct Metric {
    std::string name;
    double value;  // NaN: not defined for this log
    std::string unit;
    std::string definition;
    Say say = {};
    std::string title = {};
    std::string standard = {};
};

// The defined metrics: first those that are said, in their order, which are results; then the others, among which are
// the conditions of the test.
inline std::vector<Metric> resultsFirst(std::vector<Metric> metrics) {
    std::erase_if(metrics, [](const Metric& metric) { return !std::isfinite(metric.value); });
    const auto place = [](const Metric& metric) { return metric.say.rank > 0 ? metric.say.rank : 1000; };
    std::stable_sort(metrics.begin(), metrics.end(),
                     [&](const Metric& a, const Metric& b) { return place(a) < place(b); });
    return metrics;
}

// The title of a metric; of one without, its name with spaces.
inline std::string titleOf(const Metric& metric) {
    if (!metric.title.empty()) return metric.title;
    std::string words = metric.name;
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

}  // namespace tread
