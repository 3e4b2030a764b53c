// What drives would show of each effect before anything is fitted, as it is printed.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

struct Precheck {
    std::map<std::string, double> expected_evidence;  // nats, of each effect at its typical size
    std::vector<ConfusablePair> confusable;           // that would be left so if one of them were true, worst first
    std::vector<std::string> warnings;                // of what is left out of the drives
    int simulations = 0;
};

// The effects by what the drives would show of them, each group the clearest first.
struct Visibility {
    using Group = std::vector<std::pair<std::string, double>>;  // with the nats to expect
    Group found;                                                // enough for the thresholds of a verdict
    Group perhaps;                                              // enough to stand out, if it is larger than is typical
    Group hidden;
};
Visibility visibility(const std::map<std::string, double>& expected_evidence);

// As it is printed: the groups, then the pairs.
std::string precheckText(const Precheck& precheck);

}  // namespace tread::diagnose::answer
