// Numbers as the page's scripts read them: little-endian, base64.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace tread {

std::string packed(std::span<const double> values);
std::string packed(std::span<const float> values);
std::string packed(std::span<const std::uint16_t> values);

// SHA-256 of a text as a content security policy names it.
std::string sha256Base64(std::string_view text);

// JSON that can stand inside a script element: no "<" in it; text that is not Unicode is replaced.
std::string scriptJson(const nlohmann::ordered_json& json);

}  // namespace tread
