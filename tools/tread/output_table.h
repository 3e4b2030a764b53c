// Tables that the program writes: a table that users bring, with columns added.
#pragma once

#include <cstddef>

#include "output.h"
#include "tyre_table.h"

namespace tread::program {

// A table that repeats an input table and adds the variables of further columns to each row; it refers to both.
class OutputTable {
public:
    // The added columns have units in brackets when one of the input's has. An empty path is standard output.
    OutputTable(const Path& path, const InputTable& input, const Columns& added);

    void write(std::size_t input_row);  // with the variables as they are now
    void finish() { file_.finish(); }

private:
    WholeFile file_;
    const InputTable& input_;
    const Columns& added_;
};

}  // namespace tread::program
