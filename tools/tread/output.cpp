#include "output.h"

#include <cerrno>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "log/csv.h"

namespace tread::program {
namespace {

[[noreturn]] void fail(const std::string& where, int error) {
    throw FileError("cannot write " + where + ": " + std::generic_category().message(error));
}

void writeTo(std::FILE* file, std::string_view text, const std::string& where) {
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    if (!written || std::fflush(file) != 0) fail(where, errno);
}

void writeNewFile(const Path& path, std::string_view text, const std::string& where) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (!file) fail(where, errno);
    try {
        writeTo(file, text, where);
    } catch (...) {
        std::fclose(file);
        throw;
    }
    // Some file systems report a full disk only on closing.
    if (std::fclose(file) != 0) fail(where, errno);
}

}  // namespace

void print(std::string_view text) {
    writeTo(stdout, text, "the answer to standard output");
}

void printJson(const nlohmann::json& value) {
    // Names in a foreign log may be in any encoding; JSON is UTF-8.
    print(value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void writeFile(const Path& path, std::string_view text) {
    const std::string where = "'" + path.string() + "'";
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::is_directory(status)) fail(where, EISDIR);
    // A device or a pipe must not be replaced by a file.
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        writeNewFile(path, text, where);
        return;
    }
    // A link stays: the file that it points to is replaced.
    const Path target = std::filesystem::exists(status) ? std::filesystem::canonical(path) : path;
    Path part = target;
    part += ".part";
    try {
        writeNewFile(part, text, where);
        std::filesystem::rename(part, target, error);
        if (error) fail(where, error.value());
    } catch (...) {
        std::filesystem::remove(part, error);
        throw;
    }
}

}  // namespace tread::program
