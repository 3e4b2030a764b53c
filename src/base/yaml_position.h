// Where a file says something that only later turns out to be wrong.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/text_file.h"

namespace tread {

// Where a YAML file says the value of a path ("phases.2.steering"); {0, 0} when it does not.
TextPosition positionOfValue(const std::string& file, std::string_view path);

// The value of a path as the file writes it ("80 km/h"); nothing when it says none, or more than one word or number.
std::optional<std::string> writtenValue(const std::string& file, std::string_view path);

}  // namespace tread
