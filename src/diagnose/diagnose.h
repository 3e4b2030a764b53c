// Diagnosis of the gap between a car and its model. The method is described in README.md beside this file.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/options.h"
#include "recording/diagnosis_file.h"

namespace tread::diagnose {

// `nominal`: the car as its file describes it, with its instruments as far as they are known. `recorded`: the result of
// readRecordings(). Throws SimulationError when the nominal car cannot be driven in the recordings, and
// std::invalid_argument, naming the recording, when nothing can be learnt from one of them.
answer::Diagnosis diagnosisOf(const recording::Subject& nominal, const recording::DiagnosisFile& file,
                              const recording::Recorded& recorded, const std::vector<catalogue::Effect>& effects,
                              const Options& options = {});

}  // namespace tread::diagnose
