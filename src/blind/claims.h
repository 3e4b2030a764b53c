// What an answer claims about a case, in the terms in which it is scored.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "blind/answer.h"
#include "blind/key.h"
#include "blind/reliability.h"

namespace tread {

// Of every effect that an answer names, also as an alternative, that it is a cause; that nothing shows; that something
// unknown acts.
std::vector<Claim> claimsOf(const CaseKey& key, const CaseAnswer& answer);

// Causes, and the effects of all alternatives.
std::set<std::string> namedIn(const CaseAnswer& answer);

bool blames(const CaseAnswer& answer);  // an effect of the catalogue
bool alarms(const CaseAnswer& answer);  // that, or something unknown

// Evidence that the drives were to show of an effect.
double natsOf(const CaseAnswer& answer, const std::string& effect);
bool testable(const CaseAnswer& answer, const std::string& effect);

// Whether the drives were to show one of the effects: nothing may be answered where they show nothing.
bool testable(const CaseKey& key, const CaseAnswer& answer);

bool has(const std::vector<std::string>& names, const std::string& name);

}  // namespace tread
