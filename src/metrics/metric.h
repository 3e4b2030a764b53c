// One number that answers a question about a run.
#pragma once

#include <string>
#include <string_view>

namespace tread {

// A metric in words, for the one line that sums a run up. That has the first few that are defined.
struct Say {
    int rank = 0;           // what says most has 1; 0: it is not said
    std::string_view text;  // {} stands for the number
    int decimals = 0;       // at most
    double scale = 1;       // from the unit of the metric to that of the text
};

struct MetricDefinition {
    std::string name;
    std::string unit;        // as the standards quote it: "deg/g", "s deg", "m"
    std::string definition;  // one sentence; says when the metric is not defined
    Say say = {};
};

struct Metric {
    std::string name;
    double value;  // NaN: not defined for this log
    std::string unit;
    std::string definition;
    Say say = {};
};

}  // namespace tread
