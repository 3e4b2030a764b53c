// The simulated drives of a diagnosis or an identification, for whoever wants to look closer.
#pragma once

#include <vector>

#include "commands.h"
#include "diagnose/answer/diagnosis.h"

namespace tread::program {

// A folder per recording: measured.csv (less what the model lacked in a reference), nominal.csv, calibrated.csv,
// extended.csv. Those of an earlier call are removed.
void writeStages(const std::vector<diagnose::answer::Overlay>& overlays, const Path& folder);

}  // namespace tread::program
