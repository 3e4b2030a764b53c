// The answer of a diagnosis as it is printed: where, which, how far, what to drive next.
#pragma once

#include <string>

#include "diagnose/diagnosis.h"

namespace tread {

std::string diagnosisText(const Diagnosis& diagnosis);

// A measured channel as people name it: "yaw rate"; one that is not known stays as it is.
std::string channelInWords(const std::string& channel);

// "p = 0.97"; nothing is certain.
std::string probabilityInWords(double p);

// What forces of unknown cause follow, with numbers; empty when nothing is known of it.
std::string lawInWords(const ForceLaw& law);

// What acts together: "grip and mass".
std::string together(const std::vector<std::string>& causes);
std::vector<std::string> eachTogether(const std::vector<std::vector<std::string>>& alternatives);

// The effects that stand in alternatives and not among the causes, each once.
std::vector<std::string> namesOnlyIn(const std::vector<std::vector<std::string>>& alternatives,
                                     const std::vector<std::string>& causes);

}  // namespace tread
