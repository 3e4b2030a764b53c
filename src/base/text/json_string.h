// Text as JSON and YAML both read it back.
#pragma once

#include <string>
#include <string_view>

namespace tread {

// In double quotes, with escapes for what may not stand between them.
std::string jsonString(std::string_view text);

}  // namespace tread
