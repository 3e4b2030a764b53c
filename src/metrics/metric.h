// One number that answers a question about a run.
#pragma once

#include <string>

namespace tread {

struct Metric {
    std::string name;
    double value;            // NaN: not defined for this log; the definition says when
    std::string unit;        // as the standards quote it: "deg/g", "s deg", "m"
    std::string definition;  // one sentence
};

}  // namespace tread
