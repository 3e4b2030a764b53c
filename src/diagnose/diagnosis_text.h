// The answer of a diagnosis as it is printed: where, which, how far, what to drive next.
#pragma once

#include <string>

#include "diagnose/diagnosis.h"

namespace tread {

std::string diagnosisText(const Diagnosis& diagnosis);

// What acts together: "grip and mass".
std::string together(const std::vector<std::string>& causes);
std::vector<std::string> eachTogether(const std::vector<std::vector<std::string>>& alternatives);

// The effects that stand in alternatives and not among the causes, each once.
std::vector<std::string> namesOnlyIn(const std::vector<std::vector<std::string>>& alternatives,
                                     const std::vector<std::string>& causes);

}  // namespace tread
