// What a foreign log says, before anybody has judged it: named columns of numbers, each with the unit that the file
// claims and the place where it stands.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tread/problem.h"

namespace tread {

struct ForeignColumn {
    std::string name;            // as in the file, without its unit
    std::string unit;            // as in the file, empty: it does not say
    std::vector<double> values;  // NaN: the file has no number there
    int line = 0;                // of the name; 0 for files without lines
    int column = 0;
    std::optional<Problem> not_a_number;  // the first cell that is neither empty nor a number
    std::string time{};                   // column with the time of these values, when the file has several rates
};

struct ForeignTable {
    std::string file;
    std::string kind;  // "VBOX file"
    std::vector<ForeignColumn> columns;
    std::vector<int> lines;          // line of each row; empty for files without lines
    std::vector<std::string> notes;  // what the reader passed over, one clause each

    const ForeignColumn* find(std::string_view name) const {
        for (const ForeignColumn& column : columns) {
            if (column.name == name) return &column;
        }
        return nullptr;
    }
};

// Reads a .vbo, .mat, .mcap or text table by what is in it, whatever its name. Throws LoadError with every fault (the
// first twenty), FileError when the file cannot be read.
ForeignTable readForeignTable(const std::filesystem::path& file);

ForeignTable parseVbo(std::string text, const std::string& file);
ForeignTable parseForeignCsv(std::string text, const std::string& file);
ForeignTable readMat(const std::filesystem::path& file);
ForeignTable parseMcap(std::string_view bytes, const std::string& file);

inline constexpr std::string_view kOwnMcap = "MCAP file of tread";  // its columns bear the names of tread's channels

}  // namespace tread
