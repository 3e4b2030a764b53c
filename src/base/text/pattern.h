// Names with a wildcard: "wheel.*.load".
#pragma once

#include <string_view>

namespace tread {

// True when the pattern, with `*` for any characters (dots too, or none), is the whole name.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace tread
