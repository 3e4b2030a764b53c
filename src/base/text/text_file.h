// Text files as they come from outside: read whole, and refused early when they cannot be text that people wrote.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tread/problem.h"

namespace tread {

// A described file is a few kilobytes; hostile text of 4 MB costs the YAML parser at most 1 GB (231 bytes a bracket).
inline constexpr std::size_t kLargestFile = 4u << 20;

// All bytes of a file, or of standard input for "-"; nothing, and the reason in `fault`, when they cannot be had. Files
// are regular, since pipes block and devices never end, and hold at most 1 GB, or as many bytes as the variable
// TREAD_LARGEST_FILE says (a LoadError when that is no number).
std::optional<std::string> readWholeFile(const std::filesystem::path& file, std::string& fault);

// The bytes of a file that people wrote, at most one more than kLargestFile; nothing, and what to do in `fault`, when
// they cannot be had.
std::optional<std::string> readTextFile(const std::filesystem::path& file, std::string& fault);

// Whether the text is UTF-8 without NUL, within size and without tabs in its indentation; the first fault otherwise.
bool isPlainText(std::string_view text, const std::string& file, std::vector<Problem>& problems);

bool isUtf8(std::string_view text);
// The first byte at which the text is not UTF-8; npos when there is none.
std::size_t findInvalidUtf8(std::string_view text);

// Line and column (from 1, in characters) of a byte of the text.
struct TextPosition {
    int line;
    int column;
};
TextPosition positionOf(std::string_view text, std::size_t byte);

}  // namespace tread
