#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

#include "base/number_text.h"
#include "log/csv.h"
#include "log/csv_header.h"

namespace tread {
namespace {

constexpr std::size_t kFlushBytes = 1 << 16;  // a crash of the whole process loses at most this much

std::string reasonOf(int error) {
    return std::generic_category().message(error);
}

}  // namespace

LogWriter::LogWriter(std::filesystem::path path, const std::vector<Column>& columns)
    : path_(std::move(path)), part_(path_), incomplete_(path_), columns_(columns.size()) {
    part_ += ".part";
    incomplete_.replace_extension(".incomplete.csv");
    if (const std::string fault = columnFault(columns); !fault.empty()) {
        throw FileError("cannot write '" + path_.string() + "': " + fault);
    }
    file_.reset(std::fopen(part_.c_str(), "wb"));
    if (!file_) throw FileError("cannot write '" + part_.string() + "': " + reasonOf(errno));
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // one buffer is enough, and ours knows where rows end
    buffer_ = headerRow(columns);
    header_bytes_ = buffer_.size();
}

LogWriter::~LogWriter() {
    if (file_) keepIncomplete();
}

void LogWriter::write(std::span<const double> row) {
    assert(row.size() == columns_ && file_);
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (i > 0) buffer_ += ',';
        appendNumber(buffer_, row[i]);
    }
    buffer_ += '\n';
    if (buffer_.size() >= kFlushBytes) flush();
}

void LogWriter::finish() {
    assert(file_);
    flush();
    // The rows must be on the disk before the name is: some file systems report a full disk only here or on closing.
    if (fsync(fileno(file_.get())) != 0) fail(reasonOf(errno));
    close();
    std::error_code error;
    std::filesystem::rename(part_, path_, error);
    if (error) fail(error.message());
}

std::string LogWriter::keepIncomplete() {
    assert(file_);
    try {
        flush();
        close();
    } catch (const FileError& error) {
        return error.what();
    }
    return nameIncomplete();
}

void LogWriter::flush() {
    const std::size_t written = std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get());
    if (written == buffer_.size()) {
        row_bytes_ += written;
        buffer_.clear();
        return;
    }
    const int error = errno;
    const std::size_t row_end = std::string_view(buffer_).substr(0, written).rfind('\n');
    if (row_end != std::string_view::npos) row_bytes_ += row_end + 1;
    fail(reasonOf(error));
}

void LogWriter::close() {
    if (std::fclose(file_.release()) != 0) fail(reasonOf(errno));
}

// Cuts off a torn last row and gives the rest the name that says so; without a whole row the file goes.
std::string LogWriter::nameIncomplete() {
    std::error_code error;
    if (row_bytes_ <= header_bytes_) {
        std::filesystem::remove(part_, error);
        return "no row was written";
    }
    if (std::filesystem::file_size(part_, error) > row_bytes_) std::filesystem::resize_file(part_, row_bytes_, error);
    if (!error) std::filesystem::rename(part_, incomplete_, error);
    if (!error) return "the rows so far are in '" + incomplete_.string() + "'";
    return "the rows so far stay in '" + part_.string() + "', which cannot become '" + incomplete_.string() +
           "': " + error.message();
}

void LogWriter::fail(const std::string& reason) {
    file_.reset();
    throw FileError("cannot write '" + path_.string() + "': " + reason + "; " + nameIncomplete());
}

void writeLog(const std::filesystem::path& path, const Log& log) {
    std::vector<Column> columns;
    for (const Channel& channel : log.channels) columns.push_back({channel.name, channel.unit});
    LogWriter writer(path, columns);
    std::vector<double> row(columns.size());
    for (std::size_t sample = 0; sample < log.samples(); ++sample) {
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = log.channels[i].values[sample];
        writer.write(row);
    }
    writer.finish();
}

}  // namespace tread
