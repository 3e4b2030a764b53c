// Tables that the program writes: a table that users bring, with columns added.
#pragma once

#include <cstddef>
#include <span>

#include "output.h"
#include "tyre_table.h"

namespace tread::program {

// A table that repeats an input table and adds columns to each row. It must not outlive the input.
class OutputTable {
public:
    // The added columns have units in brackets when one of the input's has. An empty path is standard output.
    OutputTable(const Path& path, const InputTable& input, std::span<const ColumnKind> added);

    void write(std::size_t input_row, std::span<const double> added);
    void finish() { file_.finish(); }

private:
    OutputFile file_;
    const InputTable& input_;
};

}  // namespace tread::program
