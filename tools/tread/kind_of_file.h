// What a YAML file is, judged by its outermost keys.
#pragma once

#include <string>
#include <vector>

#include "base/yaml_document.h"
#include "describable.h"

namespace tread::program {

// The outermost keys; none for what is no mapping.
std::vector<std::string> keysOf(const YamlDocument& document);

// The kind of file whose description has most of the keys; nullptr when none fits or several fit equally.
const Describable* bestMatch(const std::vector<std::string>& keys);

// `"a", "b" and 3 more`, for a message.
std::string foundKeys(const std::vector<std::string>& keys);

}  // namespace tread::program
