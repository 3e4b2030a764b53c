// Files and tables that the program writes: whole or not at all.
#pragma once

#include <cstdio>
#include <span>
#include <string>
#include <string_view>

#include "tyre_table.h"

namespace tread::program {

// A file that gets its name only when it is complete; until then it is `<name>.part`, removed when the writer gives up.
// An empty name is standard output; devices and pipes are written to directly. Throws FileError.
class OutputFile {
public:
    explicit OutputFile(const std::string& name);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view text);
    void finish();

private:
    [[noreturn]] void fail(const Path& path, int error) const;

    Path path_;  // empty: standard output
    Path part_;  // empty: written to directly
    std::FILE* file_ = nullptr;
};

// A table that repeats an input table and adds columns to each row.
class OutputTable {
public:
    // The added columns have units in brackets when one of the input's has.
    OutputTable(OutputFile& file, const InputTable& input, std::span<const ColumnKind> added);

    void write(std::size_t input_row, std::span<const double> added);
    void finish();

private:
    OutputFile& file_;
    const InputTable& input_;
    std::string buffer_;
};

}  // namespace tread::program
