// Numbers as text: exact both ways, independent of the locale.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "tread/describe.h"

namespace tread {

// Shortest decimal text that reads back to the same finite number.
std::string numberText(double value);

// Appends a cell of a table: the shortest digits that read back to the same number, and one spelling of NaN whatever
// its sign bit.
void appendNumber(std::string& out, double value);

// The decimal number at the beginning of `text`, which is then moved behind it. Nothing for infinities, NaN, numbers
// beyond the range of a double, and numbers that run on into something else ("0x10", "1_000", "1,5").
std::optional<double> takeNumber(std::string_view& text);

// "at least 0", "above 0 and below 2", "from 0 to 1"; empty when every number is allowed.
std::string limitsText(const Limits& limits);

// "1 run", "3 runs"; `what` is the word for one of them.
std::string counted(std::size_t number, std::string_view what);

// Text for a message: in quotes, control characters replaced, cut when long.
std::string quote(std::string_view text, std::size_t longest = 60);

}  // namespace tread
