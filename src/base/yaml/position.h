// Where a file says something that only later turns out to be wrong.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/text/text_file.h"

namespace tread {

// Where a YAML file says the value of a path ("phases.2.steering"); {0, 0} when it does not.
TextPosition positionOfValue(const std::string& file, std::string_view path);

// A value as it is written, in the file or in one that the file names in place of a value.
struct WrittenValue {
    std::string file;
    TextPosition at;
    std::string text;  // of a number or word; empty for a list or map
};
std::optional<WrittenValue> writtenValue(const std::string& file, std::string_view path);

}  // namespace tread
