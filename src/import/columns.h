// Finding columns of a foreign log and their units; what is wrong is said of the mapping, at `path` in it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "import/formats/foreign_table.h"

namespace tread {

// Throws LoadError, with a suggestion, when the file has no such column.
const ForeignColumn& foreignColumn(const ForeignTable& table, const std::string& name, const std::string& path);

// Throws LoadError when one of its cells is something else.
void expectNumbers(const ForeignColumn& column);

// The unit of the values, as tread spells it: the given one, else what the file says, else its name, else
// `otherwise`; nothing when the file has none or one that nobody knows. Throws LoadError for a given one like that.
std::optional<std::string> foreignUnit(const ForeignColumn& column, const std::string& given, const std::string& path,
                                       std::string_view otherwise = {});

struct Scaling {
    double numerator = 1, denominator = 1, offset = 0;
    double operator()(double value) const { return value * numerator / denominator + offset; }
};

// From one unit to another of the same kind; throws LoadError when they measure different things.
Scaling scalingTo(const std::string& from, const std::string& to, const std::string& path, const ForeignColumn& column);

}  // namespace tread
