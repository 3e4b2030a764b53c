// The answer of a diagnosis as it is printed: where, which, how far, what to drive next.
#pragma once

#include <string>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

std::string diagnosisText(const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
