// diagnosis.json: the answer of a diagnosis, name by name.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

std::string_view nameOf(Verdict verdict);
// Nothing when no verdict has that name.
std::optional<Verdict> verdictNamed(std::string_view name);

nlohmann::ordered_json effectJson(const RankedEffect& effect);

nlohmann::ordered_json confusableJson(const std::vector<ConfusablePair>& pairs);

nlohmann::ordered_json baselinesJson(const Baselines& baselines);

nlohmann::ordered_json diagnosisJson(const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
