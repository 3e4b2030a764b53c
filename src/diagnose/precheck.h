// Before a diagnosis: what would these drives show of each effect, if it were there in the nominal car?
#pragma once

#include "diagnose/answer/precheck.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/options.h"
#include "recording/diagnosis_file.h"

namespace tread::diagnose {

// As diagnosisOf(), but linear about the nominal car: nothing is fitted and no effect is sought. Tolerances,
// instruments and disturbances of the usual sizes imitate what they can of each effect; what is left counts. Throws
// what diagnosisOf() throws.
answer::Precheck precheckOf(const recording::Subject& nominal, const recording::DiagnosisFile& file,
                            const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                            const Options& options = {});

}  // namespace tread::diagnose
