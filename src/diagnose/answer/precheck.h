// Result of the check before a diagnosis: how well the drives would show each effect.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

struct Precheck {
    std::map<std::string, double> expected_evidence;  // nats, of each effect at its typical size
    std::vector<ConfusablePair> confusable;           // the drives could not tell which is true; worst first
    std::vector<std::string> warnings;                // about parts of the drives that are left out
    int simulations = 0;
};

// Effects grouped by how well the drives would show them; within a group the clearest first.
struct Visibility {
    using Group = std::vector<std::pair<std::string, double>>;  // effects with their expected evidence, nats
    Group found;                                                // enough for a verdict
    Group perhaps;                                              // enough only if the effect is larger than typical
    Group hidden;
};
Visibility visibility(const std::map<std::string, double>& expected_evidence);

// The printed check: the groups, then the pairs.
std::string precheckText(const Precheck& precheck);

}  // namespace tread::diagnose::answer
