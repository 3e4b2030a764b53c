// The value of an expression over a whole log.
#pragma once

#include "log/log.h"
#include "metrics/own/own_metrics.h"
#include "scenario/expression/term.h"

namespace tread {

// Of a term that gives one number, in SI; NaN: undefined.
double evaluate(const Term& term, const Log& log, const std::vector<RunParameter>& parameters,
                const std::vector<std::string>& phases);

}  // namespace tread
