// Report of a diagnosis: first the answer in words, then the figures that support it.
#pragma once

#include <string>

#include "diagnose/answer/diagnosis.h"

namespace tread {

struct DiagnosisReport {
    std::string title;
    std::string vehicle;  // name of the nominal car
    std::string version;
    const diagnose::answer::Diagnosis& diagnosis;
};

std::string diagnosisReport(const DiagnosisReport& content);

}  // namespace tread
