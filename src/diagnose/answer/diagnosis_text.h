// The answer of a diagnosis as printed: the headline, the parts of the gap, where it is, which effects cause it, what
// remains, what was left out, and what to drive next.
#pragma once

#include <string>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

std::string diagnosisText(const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
