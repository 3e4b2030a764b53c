// The effects that a diagnosis is asked to consider.
#pragma once

#include <vector>

#include "diagnose/catalogue/effect.h"
#include "recording/diagnosis_file.h"

namespace tread::diagnose::catalogue {

// Those of the catalogue and the user's own that the file asks for. Throws LoadError with every fault.
std::vector<Effect> effectsToConsider(const recording::DiagnosisFile& file);

}  // namespace tread::diagnose::catalogue
