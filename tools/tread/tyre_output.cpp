#include "tyre_output.h"

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <system_error>

#include "base/concat.h"
#include "log/csv.h"

namespace tread::program {
namespace {

constexpr std::size_t kFlushBytes = 1 << 16;

void appendNumber(std::string& out, double value) {
    char digits[32];  // the longest double has 24 characters
    out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

// A pipe or device has no place for a temporary name beside it, and must not be replaced by a file.
bool isDirect(const Path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

}  // namespace

OutputFile::OutputFile(const std::string& name) : path_(name) {
    if (name.empty()) {
        file_ = stdout;
        return;
    }
    std::error_code error;
    if (std::filesystem::is_directory(path_, error)) fail(path_, EISDIR);
    if (std::filesystem::is_symlink(path_, error) && !isDirect(path_)) path_ = std::filesystem::weakly_canonical(path_);
    if (!isDirect(path_)) {
        part_ = path_;
        part_ += ".part";
    }
    const Path& opened = part_.empty() ? path_ : part_;
    file_ = std::fopen(opened.c_str(), "wb");
    if (!file_) fail(path_, errno);
}

OutputFile::~OutputFile() {
    if (!file_ || file_ == stdout) return;
    std::fclose(file_);
    std::error_code error;
    if (!part_.empty()) std::filesystem::remove(part_, error);
}

void OutputFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(path_, errno);
}

void OutputFile::finish() {
    if (std::fflush(file_) != 0) fail(path_, errno);
    if (file_ == stdout) return;
    // Some file systems report a full disk only on closing.
    std::FILE* const file = std::exchange(file_, nullptr);
    std::error_code error;
    const int closing = std::fclose(file) == 0 ? 0 : errno;
    if (closing == 0 && !part_.empty()) std::filesystem::rename(part_, path_, error);
    const int reason = closing != 0 ? closing : error.value();
    if (reason == 0) return;
    if (!part_.empty()) std::filesystem::remove(part_, error);
    fail(path_, reason);
}

void OutputFile::fail(const Path& path, int error) const {
    throw FileError(concat({"cannot write ", path.empty() ? "to standard output" : "'" + path.string() + "'", ": ",
                            std::generic_category().message(error)}));
}

OutputTable::OutputTable(OutputFile& file, const InputTable& input, std::span<const ColumnKind> added)
    : file_(file), input_(input) {
    for (const TableColumn& column : input.columns) {
        if (!buffer_.empty()) buffer_ += ',';
        buffer_ += column.header;
    }
    for (const ColumnKind& kind : added) {
        buffer_ += concat({",", kind.name});
        if (input.has_units) buffer_ += concat({" [", kind.about.unit, "]"});
    }
    buffer_ += '\n';
}

void OutputTable::write(std::size_t input_row, std::span<const double> added) {
    for (std::size_t column = 0; column < input_.columns.size(); ++column) {
        if (column > 0) buffer_ += ',';
        appendNumber(buffer_, input_.given(input_row, column));
    }
    for (const double value : added) {
        buffer_ += ',';
        appendNumber(buffer_, value);
    }
    buffer_ += '\n';
    if (buffer_.size() < kFlushBytes) return;
    file_.write(buffer_);
    buffer_.clear();
}

void OutputTable::finish() {
    file_.write(buffer_);
    buffer_.clear();
    file_.finish();
}

}  // namespace tread::program
