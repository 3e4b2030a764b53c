// The answer of a diagnosis as printed: where the gap is, which effects cause it, how far they close it, what to drive
// next.
#pragma once

#include <string>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

std::string diagnosisText(const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
