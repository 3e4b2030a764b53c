// Check before a diagnosis: how well would these drives show each effect, if the nominal car had it?
#pragma once

#include "diagnose/answer/precheck.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/options.h"
#include "recording/diagnosis_file.h"

namespace tread::diagnose {

// Takes the arguments of diagnosisOf() but stays linear about the nominal car: nothing is fitted and no effect is
// searched for. Tolerances, instruments and disturbances of the usual sizes are marginalised, and only the part of an
// effect that they cannot imitate counts. Throws what diagnosisOf() throws.
answer::Precheck precheckOf(const recording::Subject& nominal, const recording::DiagnosisFile& file,
                            const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                            const Options& options = {});

}  // namespace tread::diagnose
