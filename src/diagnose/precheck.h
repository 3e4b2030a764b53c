// Before a diagnosis: what would these drives show of each effect, if it were there in the nominal car?
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/diagnosis.h"

namespace tread {

struct Precheck {
    std::map<std::string, double> testable;  // nats to expect at typical size, per effect that the car can show
    std::vector<ConfusablePair> confusable;  // that would be left so if one of them were true, worst first
    std::vector<std::string> warnings;       // of what is left out of the drives
    int simulations = 0;
};

// As diagnose(), but linear about the nominal car: nothing is fitted and no effect is sought. Tolerances, instruments
// and disturbances of the usual sizes imitate what they can of each effect; what is left counts. Throws what diagnose()
// throws.
Precheck precheck(const Subject& nominal, const DiagnosisFile& file, const Recorded& recorded,
                  const std::vector<Effect>& effects, const DiagnoseOptions& options = {});

// The effects by what the drives would show of them, each group the clearest first.
struct Visibility {
    using Group = std::vector<std::pair<std::string, double>>;  // with the nats to expect
    Group found;                                                // enough for the thresholds of a verdict
    Group perhaps;                                              // enough to stand out, if it is larger than is typical
    Group hidden;
};
Visibility visibility(const std::map<std::string, double>& testable);

// As it is printed: the groups, then the pairs.
std::string precheckText(const Precheck& precheck);

}  // namespace tread
