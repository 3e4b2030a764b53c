// The time base of a foreign log: which of its rows follow one another in time.
#pragma once

#include <cstddef>
#include <vector>

#include "import/import.h"

namespace tread {

// Rows of one uninterrupted recording, with their time in s from its first.
struct Stretch {
    std::vector<std::size_t> rows;
    std::vector<double> time;
    double begin = 0;  // s, on the clock of the file

    double duration() const { return time.empty() ? 0 : time.back(); }
};

// Time of every row in s on the clock of the file, or its numbers over the rate.
std::vector<double> timeOfRows(const ForeignTable& table, const ImportTime& how, std::vector<Change>& changes);

// Rows without time and repeated stamps dropped, split where time jumps. Strictly increasing within each.
std::vector<Stretch> recordingsOf(const std::vector<double>& time, const ForeignTable& table,
                                  const ImportRepairs& repairs, std::vector<Change>& changes);

}  // namespace tread
