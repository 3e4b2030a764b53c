// Log files: CSV, one header row of `name [unit]`, SI, the first column `time [s]`, shortest round-trip numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "tread/problem.h"

namespace tread {

// The operating system refused: one sentence with the file and the reason.
class FileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct Column {
    std::string name;
    std::string unit;
};

// Writes a log row by row. Until finish() the rows are in `<path>.part`; then the file gets its name. A writer that is
// destroyed before, or that hits a full disk, leaves the whole rows so far in `<stem>.incomplete.csv`. FileError says
// why the log ended and what became of its rows.
class LogWriter {
public:
    LogWriter(std::filesystem::path path, const std::vector<Column>& columns);
    ~LogWriter();
    LogWriter(const LogWriter&) = delete;
    LogWriter& operator=(const LogWriter&) = delete;

    void write(std::span<const double> row);  // one value per column
    void finish();
    // Ends the log before its end, as the destructor does, and tells what became of its rows.
    std::string keepIncomplete();

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    void flush();
    void close();
    std::string nameIncomplete();
    [[noreturn]] void fail(const std::string& reason);

    std::filesystem::path path_;
    std::filesystem::path part_;
    std::filesystem::path incomplete_;
    std::unique_ptr<std::FILE, Close> file_;
    std::string buffer_;               // whole rows that are not yet in the file
    std::uintmax_t row_bytes_ = 0;     // size of the file up to the end of its last whole row
    std::uintmax_t header_bytes_ = 0;  // of these, before the first row
    std::size_t columns_;
};

void writeLog(const std::filesystem::path& path, const Log& log);

// The whole file, however large; throws FileError.
std::string readBytes(const std::filesystem::path& path);

// Throws LoadError with every fault (the first twenty), FileError when the file cannot be read.
Log readLog(const std::filesystem::path& path);
// The same for text in memory; `file` is the name used in the faults.
Log parseLog(std::string_view text, const std::string& file);

}  // namespace tread
