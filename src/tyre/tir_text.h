// The text of a .tir file: sections of `KEY = value`, comments behind `$` and `!`, tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tread/problem.h"

namespace tread {

struct TirEntry {
    std::string section;  // upper case, as keys are
    std::string key;
    std::string value;  // without quotes
    bool quoted = false;
    int line = 0;
    int column = 0;  // of the value
};

struct TirText {
    std::string file;
    std::vector<std::string> sections;
    std::vector<TirEntry> entries;  // in the order of the file; table rows are left out

    bool hasSection(std::string_view name) const;
    // Entries of that key in any section but [UNITS], or in [UNITS] alone (its keys are also keys elsewhere: MASS).
    std::vector<const TirEntry*> find(std::string_view key, bool units = false) const;
};

std::string upperCase(std::string_view text);

// The number that a value says; nothing when it is not a finite number and nothing else.
std::optional<double> numberIn(const TirEntry& entry);

// Faults of lines are added to `problems`, which name `file`.
TirText parseTirText(std::string_view content, const std::string& file, std::vector<Problem>& problems);

}  // namespace tread
