// One channel of the mapping, read from its columns over all rows of the file: units, sign, scale.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "import/import.h"

namespace tread {

// In its unit; delay, zero and offset come later, on one recording.
struct WholeChannel {
    const ImportChannel* how;
    std::string unit;
    std::vector<double> values;  // on the rows of the file's time base
    // s, on the clock of the file: where it has values, when its own time is another than that of the rows.
    double first = -std::numeric_limits<double>::infinity(), last = std::numeric_limits<double>::infinity();
};

// The channel map.map[index]. `time` is that of the rows. Throws LoadError.
WholeChannel readChannel(const ForeignTable& table, const ImportMap& map, std::size_t index,
                         const std::vector<double>& time, std::vector<Change>& changes);

}  // namespace tread
