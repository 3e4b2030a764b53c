// The report of a diagnosis: the answer in words first, then what it rests on.
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
