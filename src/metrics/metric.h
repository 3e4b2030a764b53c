// One number that answers a question about a run.
#pragma once

#include <string>

namespace tread {

struct MetricDefinition {
    std::string name;
    std::string unit;        // as the standards quote it: "deg/g", "s deg", "m"
    std::string definition;  // one sentence; says when the metric is not defined
};

struct Metric {
    std::string name;
    double value;  // NaN: not defined for this log
    std::string unit;
    std::string definition;
};

}  // namespace tread
