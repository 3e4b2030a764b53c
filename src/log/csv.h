// Log files: CSV, one header row of `name [unit]`, SI, the first column `time [s]`, shortest round-trip numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "store/whole_file.h"
#include "tread/problem.h"

namespace tread {

struct Column {
    std::string name;
    std::string unit;
};

// Writes a log row by row, as a whole file. A writer that is destroyed before finish(), or that hits a full disk,
// leaves the whole rows so far in `<stem>.incomplete.csv`. FileError says why the log ended and what became of its
// rows.
class LogWriter {
public:
    LogWriter(const std::filesystem::path& path, const std::vector<Column>& columns);
    ~LogWriter();
    LogWriter(const LogWriter&) = delete;
    LogWriter& operator=(const LogWriter&) = delete;

    void write(std::span<const double> row);  // one value per column
    void finish();
    // Ends the log before its end, as the destructor does, and tells what became of its rows.
    std::string keepIncomplete();

private:
    void flush();
    std::string nameIncomplete();
    [[noreturn]] void fail(const FileError& error);

    std::filesystem::path incomplete_;
    std::optional<WholeFile> file_;    // none: the log has ended
    std::string buffer_;               // whole rows that are not yet in the file
    std::uintmax_t row_bytes_ = 0;     // size of the file up to the end of its last whole row
    std::uintmax_t header_bytes_ = 0;  // of these, before the first row
    std::size_t columns_;
};

void writeLog(const std::filesystem::path& path, const Log& log);

// The whole file, however large; throws FileError.
std::string readBytes(const std::filesystem::path& path);

// Throws LoadError with every fault (the first twenty), or when it lies in a folder that is marked as incomplete;
// FileError when the file cannot be read.
Log readLog(const std::filesystem::path& path);
// The same for text in memory; `file` is the name used in the faults.
Log parseLog(std::string_view text, const std::string& file);

}  // namespace tread
