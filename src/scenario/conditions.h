// The conditions on channels that end phases: what is wrong with them.
#pragma once

#include <string>
#include <vector>

#include "scenario/expression/check.h"
#include "scenario/scenario.h"

namespace tread {

struct ConditionFault {
    std::string path;  // "phases.2.until.when"
    ExpressionText condition;
    std::size_t at;  // byte of it
    std::string text;
};

std::vector<ConditionFault> conditionFaults(const Scenario& scenario, const std::vector<KnownName>& channels);

}  // namespace tread
