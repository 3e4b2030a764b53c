// Text within HTML, SVG and XML.
#pragma once

#include <string>
#include <string_view>

namespace tread {

// For element content and quoted attributes; control characters, which XML forbids, are dropped.
std::string escapeMarkup(std::string_view text);

}  // namespace tread
