// The one way in which files are written: a file is whole or not there, and an earlier one stays until the new one is
// whole, on disks that several processes and machines share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tread {

// The operating system refused: one sentence with the file and the reason.
class FileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// A file in the making, under a temporary name beside its place that nobody else uses, until finish() gives it its name
// in one step. The file that it replaces keeps its permissions; one that may not be written is refused. A link stays,
// and what it points to is replaced. A device or a pipe is written to directly, and so is standard output, which an
// empty name stands for. Every function throws FileError.
class WholeFile {
public:
    explicit WholeFile(std::filesystem::path file);
    ~WholeFile();  // what has not been finished goes
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    void write(std::string_view text);
    // Hands on to the operating system what write() has gathered.
    void flush();
    void finish();
    // Ends the file before its end: its first bytes get another name.
    void keepAs(const std::filesystem::path& other, std::uintmax_t bytes);

    // What the operating system has taken, bytes.
    std::uintmax_t written() const { return written_; }
    // The temporary name, for a library that writes by name.
    const std::filesystem::path& part() const { return part_; }

private:
    void openDirectly();
    void openPart();
    void nameIt(const std::filesystem::path& name);
    void close();
    [[noreturn]] void fail(int error, const std::filesystem::path& name) const;

    std::filesystem::path name_;    // as given
    std::filesystem::path target_;  // without links
    std::filesystem::path part_;    // empty: written to directly
    std::string buffer_;
    std::uintmax_t written_ = 0;
    int file_ = -1;
};

void writeFile(const std::filesystem::path& file, std::string_view text);

// Removes what processes that were killed have left in a folder under temporary names. The first file that a process
// writes into a folder does so too.
void removeLeftovers(const std::filesystem::path& folder);

}  // namespace tread
