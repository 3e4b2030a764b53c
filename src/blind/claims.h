// What an answer claims about a case, in the terms in which it is scored.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "blind/answer.h"
#include "blind/key.h"
#include "blind/reliability.h"

namespace tread {

// Of every effect that an answer names, also as an alternative, that it is a cause: right when it acts. That nothing is
// wrong: right when the drives show less than 6 nats of everything that is. That something unknown acts: right when
// something outside of the catalogue does, alone or beside an effect.
std::vector<Claim> claimsOf(const CaseKey& key, const CaseAnswer& answer);

// Causes, and the effects of all alternatives.
std::set<std::string> namedIn(const CaseAnswer& answer);

bool blames(const CaseAnswer& answer);  // an effect of the catalogue
bool callsUnknown(const CaseAnswer& answer);
bool alarms(const CaseAnswer& answer);  // one of both

// The best of all effects acts, and effects are blamed.
bool firstIsTrue(const CaseKey& key, const CaseAnswer& answer);

// The causes are those that act, all of them and no other, and there is no alternative.
bool namesExactly(const CaseKey& key, const CaseAnswer& answer);

// Names an effect that acts, if only as an alternative.
bool namesAnyTrue(const CaseKey& key, const CaseAnswer& answer);

// Names at least one effect, and of the causes or of one of the alternatives all are true.
bool mayBeTrue(const CaseKey& key, const CaseAnswer& answer);

bool has(const std::vector<std::string>& names, const std::string& name);
bool hasAll(const std::vector<std::string>& names, const std::vector<std::string>& of);

// ---- Numbers of the causes that were rightly named ----

struct EstimateError {
    double in_sd;     // truth within 2: a hit; infinite at a bound and without a standard deviation
    double relative;  // to the distance of the truth from the nominal car's number
};
std::vector<EstimateError> numberErrors(const CaseKey& key, const CaseAnswer& answer);

}  // namespace tread
