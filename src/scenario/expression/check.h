// Names and units of an expression: whether all names are known, and which unit comes out.
//
// The radian counts as 1, as in the SI: yaw rate times speed is an acceleration. An angle is still no pure number where
// a metric states its unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenario/expression/term.h"

namespace tread {

struct KnownName {
    std::string name;
    std::string unit;  // as in a log
};

// What an expression may name. `parameters` with "vehicle." and "scenario." before their paths.
struct KnownNames {
    std::vector<KnownName> channels = {};
    std::vector<KnownName> parameters = {};
    std::vector<std::string> phases = {};
    bool at_one_moment = false;  // a condition of a phase: no functions over time
    bool any_phase = false;      // the phases are not known
};

// Fills in what a term is; false, and what is wrong in `fault`, when it cannot be computed.
bool checkTerm(Term& term, const KnownNames& known, ExpressionFault& fault);

// The same of a condition: a comparison at one moment.
bool checkCondition(Term& term, const KnownNames& known, ExpressionFault& fault);

// The same of a metric, which is one number with this unit.
bool checkMetric(Term& term, std::string_view unit, const KnownNames& known, ExpressionFault& fault);

}  // namespace tread
