// The header row of a log file: what a legal list of columns is, said once for the writer and the reader.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "log/csv.h"

namespace tread {

// What is wrong with these columns, as one clause; empty when nothing is.
std::string columnFault(const std::vector<Column>& columns);

// "time [s],chassis.ay [m/s2]\n"; cells with a comma or a quote are quoted.
std::string headerRow(const std::vector<Column>& columns);

struct HeaderCell {
    std::string text;    // without quotes and surrounding blanks
    std::size_t column;  // where it starts, from 1
    bool closed = true;  // false: a quote is left open, or text follows the closing quote
};

std::vector<HeaderCell> splitHeader(std::string_view line);

// The header's columns; faults are added to `problems` with their place.
std::vector<Column> readHeader(std::string_view line, int line_number, const std::string& file,
                               std::vector<Problem>& problems);

// Text of a file as it may stand in a message: short, without control characters.
std::string shown(std::string_view text);

}  // namespace tread
