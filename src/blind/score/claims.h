// Claims of an answer about a case, and whether they are right.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "blind/answers/answer.h"
#include "blind/key/key.h"
#include "blind/score/reliability.h"

namespace tread::blind::score {

// All claims with their stated probabilities. Each named effect, also as an alternative: right if it is planted.
// "Nothing": right if no fault is detectable (bands.h). "Unknown": right if there is an outsider, alone or beside an
// effect.
std::vector<Claim> claimsOf(const key::CaseKey& key, const answers::CaseAnswer& answer);

// Causes and the effects of all alternatives.
std::set<std::string> namedIn(const answers::CaseAnswer& answer);

bool blames(const answers::CaseAnswer& answer);  // names an effect of the catalogue as a cause
bool callsUnknown(const answers::CaseAnswer& answer);
bool alarms(const answers::CaseAnswer& answer);  // either of these

// Effects are blamed, and the most probable one is planted.
bool firstIsTrue(const key::CaseKey& key, const answers::CaseAnswer& answer);

// The causes are exactly the planted effects, and there is no alternative.
bool namesExactly(const key::CaseKey& key, const answers::CaseAnswer& answer);

// Names a planted effect, if only as an alternative.
bool namesAnyTrue(const key::CaseKey& key, const answers::CaseAnswer& answer);

// Blames effects, and all of the causes, or all of one alternative, are planted.
bool mayBeTrue(const key::CaseKey& key, const answers::CaseAnswer& answer);

bool has(const std::vector<std::string>& names, const std::string& name);
bool hasAll(const std::vector<std::string>& names, const std::vector<std::string>& of);

// ---- Estimated numbers of correctly named causes; with references, their changes ----

struct EstimateError {
    double in_sd;     // error over its stated standard deviation; infinite at a bound or without a standard deviation
    double relative;  // error over the true change of the number
};
std::vector<EstimateError> numberErrors(const key::CaseKey& key, const answers::CaseAnswer& answer);

}  // namespace tread::blind::score
