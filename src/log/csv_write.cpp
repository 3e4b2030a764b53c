#include <cassert>

#include "base/text/number_text.h"
#include "log/csv.h"
#include "log/csv_header.h"

namespace tread {
namespace {

constexpr std::size_t kFlushBytes = 1 << 16;  // a crash of the whole process loses at most this much

void appendRow(std::string& text, std::span<const double> row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (i > 0) text += ',';
        appendNumber(text, row[i]);
    }
    text += '\n';
}

void expectSound(const std::vector<Column>& columns, const std::filesystem::path& path) {
    const std::string fault = columnFault(columns);
    if (!fault.empty()) throw FileError("cannot write '" + path.string() + "': " + fault);
}

// The log has ended when it goes out of scope, whatever became of it.
struct Ending {
    std::optional<WholeFile>& file;
    ~Ending() { file.reset(); }
};

}  // namespace

LogWriter::LogWriter(const std::filesystem::path& path, const std::vector<Column>& columns)
    : incomplete_(path), columns_(columns.size()) {
    incomplete_.replace_extension(".incomplete.csv");
    expectSound(columns, path);
    file_.emplace(path);
    buffer_ = headerRow(columns);
    header_bytes_ = buffer_.size();
}

LogWriter::~LogWriter() {
    if (file_) keepIncomplete();
}

void LogWriter::write(std::span<const double> row) {
    assert(row.size() == columns_ && file_);
    appendRow(buffer_, row);
    if (buffer_.size() >= kFlushBytes) flush();
}

void LogWriter::finish() {
    assert(file_);
    flush();
    try {
        file_->finish();
        file_.reset();
    } catch (const FileError& error) {
        fail(error);
    }
}

std::string LogWriter::keepIncomplete() {
    assert(file_);
    try {
        flush();
    } catch (const FileError& error) {
        return error.what();
    }
    return nameIncomplete();
}

void LogWriter::flush() {
    try {
        file_->write(buffer_);
        file_->flush();
        row_bytes_ += buffer_.size();
        buffer_.clear();
    } catch (const FileError& error) {
        const std::size_t row_end = buffer_.rfind('\n', file_->written() - row_bytes_ - 1);
        if (file_->written() > row_bytes_ && row_end != std::string::npos) row_bytes_ += row_end + 1;
        fail(error);
    }
}

// Cuts off a torn last row and gives the rest the name that says so; without a whole row the file goes.
std::string LogWriter::nameIncomplete() {
    const Ending ending{file_};
    if (row_bytes_ <= header_bytes_) return "no row was written";
    try {
        file_->keepAs(incomplete_, row_bytes_);
    } catch (const FileError& error) {
        return std::string("no row was kept: ") + error.what();
    }
    return "the rows so far are in '" + incomplete_.string() + "'";
}

void LogWriter::fail(const FileError& error) {
    throw FileError(error.what() + ("; " + nameIncomplete()));
}

void writeLog(const std::filesystem::path& path, const Log& log) {
    std::vector<Column> columns;
    for (const Channel& channel : log.channels) columns.push_back({channel.name, channel.unit});
    expectSound(columns, path);
    WholeFile file(path);
    std::string text = headerRow(columns);
    std::vector<double> row(columns.size());
    for (std::size_t sample = 0; sample < log.samples(); ++sample) {
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = log.channels[i].values[sample];
        appendRow(text, row);
        if (text.size() < kFlushBytes) continue;
        file.write(text);
        text.clear();
    }
    file.write(text);
    file.finish();
}

}  // namespace tread
