// Checks of the recordings before anything is concluded from them.
#pragma once

#include <string>
#include <vector>

#include "recording/diagnosis_file.h"

namespace tread::recording::checks {

struct DataWarning {
    std::string where;  // recording, and the channel if there is one
    std::string what;   // finding
    std::string why;    // consequence for the diagnosis
    std::string advice;
};

// "step_1, chassis.ay: what. Why. Advice."
std::string toText(const DataWarning& warning);

// All warnings, in the order of the recordings, each recording before its reference. `recorded`: result of
// readRecordings().
std::vector<DataWarning> dataWarnings(const DiagnosisFile& file, const Recorded& recorded, const Subject& nominal);

}  // namespace tread::recording::checks
