// Tables of numbers that users bring: CSV with a header of names in any order, each with an optional unit in brackets.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/units/units.h"
#include "commands.h"
#include "tread/describe.h"

namespace tread::program {

// A column that a table must or may have.
struct ColumnKind {
    std::string name;
    About about;
    bool required = true;
};

struct TableColumn {
    std::string header;  // as given: "Vx [km/h]"
    std::size_t kind;    // its place in the list of kinds
    Unit unit;           // of its values
};

inline double toSi(double value, const Unit& unit) {
    return value * unit.numerator / unit.denominator + unit.offset;
}

struct InputTable {
    std::string file;
    std::vector<TableColumn> columns;  // in the order of the file
    bool has_units = false;            // at least one header has a unit in brackets
    std::vector<double> values;        // as given, row by row
    std::vector<int> places;           // where each value stands in its line, from 1
    std::vector<int> lines;            // of the file, one for each row

    std::size_t rows() const { return lines.size(); }
    double given(std::size_t row, std::size_t column) const { return values[row * columns.size() + column]; }
    int place(std::size_t row, std::size_t column) const { return places[row * columns.size() + column]; }
    double si(std::size_t row, std::size_t column) const { return toSi(given(row, column), columns[column].unit); }
};

// Columns and the variables behind them: value in the column = sign * variable, in SI.
struct Columns {
    struct Variable {
        double* value;
        double sign;
    };
    std::vector<ColumnKind> kinds;
    std::vector<Variable> variables;  // one for each kind

    void add(ColumnKind kind, double& variable, double sign = 1);
};

// Throws LoadError with every fault (the first twenty): unreadable file, unknown, repeated or missing columns, wrong
// units, rows of another length than the header, text in place of numbers, numbers that are not finite or not allowed.
InputTable readTable(const Path& file, const std::vector<ColumnKind>& kinds);

// From a row of the table, read with the kinds of `columns`, to the variables.
void fill(const Columns& columns, const InputTable& table, std::size_t row);
}  // namespace tread::program
