#include "write_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "log/csv.h"

namespace tread::program {

void writeFile(const std::filesystem::path& file, std::string_view content) {
    const std::filesystem::path part = file.string() + ".part";
    const auto fail = [&](const char* verb) {
        const int reason = errno;
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw FileError(fmt::format("cannot {} {}: {}", verb, file.string(), std::strerror(reason)));
    };
    std::FILE* stream = std::fopen(part.c_str(), "wb");
    if (!stream) fail("create");
    const bool written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
    const bool closed = std::fclose(stream) == 0;
    if (!written || !closed) fail("write");
    if (std::rename(part.c_str(), file.c_str()) != 0) fail("rename the finished file to");
}

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw FileError(
            fmt::format("cannot create the folder {}: {}; choose another with -o", folder.string(), error.message()));
}

}  // namespace tread::program
