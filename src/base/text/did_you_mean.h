// The word that a mistyped one was probably meant to be.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tread {

// The nearest of the candidates, when one is near enough to be worth naming.
std::optional<std::string_view> closest(std::string_view word, std::span<const std::string_view> candidates);

// "; did you mean "x"?", or nothing.
std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates);

// "a, b or c".
std::string listed(std::span<const std::string_view> words);

}  // namespace tread
