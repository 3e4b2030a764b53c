// The answer of a diagnosis as diagnosis.json.
#pragma once

#include <nlohmann/json.hpp>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

std::string_view nameOf(Verdict verdict);

nlohmann::ordered_json confusableJson(const std::vector<ConfusablePair>& pairs);

nlohmann::ordered_json diagnosisJson(const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
