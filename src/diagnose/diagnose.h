// The diagnosis of the gap between a car and its model: README.md beside this file has the method.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/options.h"
#include "recording/diagnosis_file.h"

namespace tread::diagnose {

// `nominal` is the car as its file says, with the instruments as far as they are known; `recorded` is what
// readRecordings gives. Throws SimulationError when the nominal car cannot be driven in the recordings, and
// std::invalid_argument that names the recording from which nothing can be learnt.
answer::Diagnosis diagnosisOf(const recording::Subject& nominal, const recording::DiagnosisFile& file,
                              const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                              const Options& options = {});

}  // namespace tread::diagnose
