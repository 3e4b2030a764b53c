// The answer of a diagnosis as it is printed: where, which, how far, what to drive next.
#pragma once

#include <string>

#include "diagnose/diagnosis.h"

namespace tread {

std::string diagnosisText(const Diagnosis& diagnosis);

}  // namespace tread
