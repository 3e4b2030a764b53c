// The text of a foreign log: its lines, cells and numbers, in UTF-8 whatever they were written in.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tread/problem.h"

namespace tread {

inline constexpr std::size_t kMostImportFaults = 20;  // more than a person reads at once

inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();  // of an empty or unreadable cell

// Windows-1252 and Latin-1 become UTF-8, a byte order mark goes; says so in `notes`. Throws LoadError for what is no
// text.
std::string foreignText(std::string text, const std::string& file, std::vector<std::string>& notes);

struct TextLine {
    std::string_view text;  // without its end
    int number;             // from 1
};
std::vector<TextLine> linesOf(std::string_view text);

struct TextCell {
    std::string_view text;  // without blanks and quotes around it
    int column;             // from 1, in bytes
};
// Cells between delimiters; a blank stands for any number of blanks.
std::vector<TextCell> cellsOf(std::string_view line, char delimiter);

std::string_view trimmedText(std::string_view text);

// The number that is the whole cell: "1.5", "+1e3", "1,5" with a decimal comma, "10:53:17.85" as seconds. NaN for
// "nan", "inf" and the like; nothing when it is no number.
std::optional<double> cellNumber(std::string_view cell, bool decimal_comma);

// Short, and without control characters: to be shown in a message.
std::string quotedCell(std::string_view cell);

}  // namespace tread
