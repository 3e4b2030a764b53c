#include "scenario/conditions.h"

#include <optional>

#include "scenario/expression/parse.h"

namespace tread {

std::vector<ConditionFault> conditionFaults(const Scenario& scenario, const std::vector<KnownName>& channels) {
    const KnownNames known{.channels = channels, .at_one_moment = true};
    std::vector<ConditionFault> faults;
    for (std::size_t i = 0; i < scenario.phases.size(); ++i) {
        const ExpressionText& condition = scenario.phases[i].until.when;
        if (!condition) continue;
        ExpressionFault fault;
        std::optional<Term> term = parseExpression(condition.text, fault);
        if (term && checkCondition(*term, known, fault)) continue;
        faults.push_back({"phases." + std::to_string(i) + ".until.when", condition, fault.at, fault.text});
    }
    return faults;
}

}  // namespace tread
