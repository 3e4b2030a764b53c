// What the fuzzer and the tests do with a text as an expression of a condition: it is parsed, or the fault says where
// and what.
#pragma once

#include <string_view>

#include "fuzz/demand.h"
#include "scenario/expression/parse.h"

namespace tread::fuzz {

inline void expectWithin(const Term& term, std::string_view text) {
    demand(term.at <= text.size());
    for (const Term& inner : term.terms) expectWithin(inner, text);
}

// True when the text was taken.
inline bool readHostileExpression(std::string_view text) {
    ExpressionFault fault;
    const std::optional<Term> term = parseExpression(text, fault);
    if (term) expectWithin(*term, text);
    else demand(!fault.text.empty() && fault.at <= text.size());
    return term.has_value();
}

}  // namespace tread::fuzz
