// One number that answers a question about a run.
#pragma once

#include <string>

namespace tread {

struct Metric {
    std::string name;
    double value;
    std::string unit;  // SI
    std::string definition;
};

}  // namespace tread
