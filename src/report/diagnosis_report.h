// The report of a diagnosis: the answer in words first, then what it rests on.
#pragma once

#include <string>

#include "diagnose/diagnosis.h"

namespace tread {

struct DiagnosisReport {
    std::string title;
    std::string vehicle;  // name of the nominal car
    std::string version;
    const Diagnosis& diagnosis;
};

std::string diagnosisReport(const DiagnosisReport& content);

}  // namespace tread
