// Selection of the effects that a diagnosis considers.
#pragma once

#include <vector>

#include "diagnose/catalogue/effect.h"
#include "recording/diagnosis_file.h"

namespace tread::diagnose::catalogue {

// Effects of the catalogue and of the user's own file that match the patterns of the diagnosis file. Throws LoadError
// that lists every fault.
std::vector<Effect> effectsToConsider(const recording::DiagnosisFile& file);

}  // namespace tread::diagnose::catalogue
