// What looks wrong with the recordings, before anything is concluded from them.
#pragma once

#include <string>
#include <vector>

#include "recording/diagnosis_file.h"

namespace tread::recording::checks {

struct DataWarning {
    std::string where;  // recording, and channel if it concerns one
    std::string what;   // was found
    std::string why;    // it matters
    std::string advice;
};

// "step_1, chassis.ay: what. Why. Advice."
std::string toText(const DataWarning& warning);

// All that looks wrong, in the order of the recordings, each before its reference; `recorded` as readRecordings gives
// it.
std::vector<DataWarning> dataWarnings(const DiagnosisFile& file, const Recorded& recorded, const Subject& nominal);

}  // namespace tread::recording::checks
