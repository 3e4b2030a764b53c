#include "output.h"

#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "log/csv.h"

namespace tread::program {

OutputFile::OutputFile(const Path& path) : name_(path), target_(path) {
    if (path.empty()) {
        file_ = stdout;
        return;
    }
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::is_directory(status)) fail(EISDIR);
    const bool exists = std::filesystem::exists(status);
    if (!exists || std::filesystem::is_regular_file(status)) {
        if (exists) target_ = std::filesystem::canonical(path);
        part_ = target_;
        part_ += ".part";
    }
    file_ = std::fopen(part_.empty() ? path.c_str() : part_.c_str(), "wb");
    if (!file_) fail(errno);
}

OutputFile::~OutputFile() {
    if (!file_ || file_ == stdout) return;
    std::fclose(file_);
    removePart();
}

void OutputFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(errno);
}

void OutputFile::finish() {
    if (std::fflush(file_) != 0) fail(errno);
    if (file_ == stdout) return;
    // The content must be on disk before the file is renamed: some file systems report a full disk only here or on
    // closing.
    if (!part_.empty() && fsync(fileno(file_)) != 0) fail(errno);
    int fault = std::fclose(std::exchange(file_, nullptr)) == 0 ? 0 : errno;
    if (part_.empty() && fault == 0) return;
    if (fault == 0 && std::rename(part_.c_str(), target_.c_str()) != 0) fault = errno;
    if (fault == 0) return;
    removePart();
    fail(fault);
}

void OutputFile::fail(int error) const {
    const std::string where = name_.empty() ? "the answer to standard output" : "'" + name_.string() + "'";
    throw FileError("cannot write " + where + ": " + std::generic_category().message(error));
}

void OutputFile::removePart() const {
    std::error_code error;
    if (!part_.empty()) std::filesystem::remove(part_, error);
}

void writeFile(const Path& path, std::string_view text) {
    OutputFile file(path);
    file.write(text);
    file.finish();
}

void print(std::string_view text) {
    writeFile({}, text);
}

void say(std::string_view text, Tone tone) {
    if (!isQuiet()) print(coloured(text, tone, stdout));
}

void printJson(const nlohmann::json& value) {
    print(jsonText(value));
}

// Names in a foreign file may have any encoding; JSON is UTF-8.
std::string jsonText(const nlohmann::json& value) {
    return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace tread::program
