#include "store/durable_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <string>
#include <system_error>

#include "log/csv.h"

namespace tread {
namespace {

using Path = std::filesystem::path;

constexpr std::string_view kTemporary = ".tmp";

[[noreturn]] void fail(const Path& file, int error) {
    throw FileError(fmt::format("cannot write '{}': {}", file.string(), std::generic_category().message(error)));
}

std::string hostName() {
    char host[256] = "";
    gethostname(host, sizeof host - 1);
    return host;
}

// Unique among the processes of all machines that share the folder.
std::string temporaryName(const std::string& name) {
    static std::atomic<unsigned> count{0};
    return fmt::format("{}.{}.{}.{}{}", name, hostName(), getpid(), count++, kTemporary);
}

// Whether a process of this machine made the file and has ended since.
bool isLeftover(const std::string& name) {
    if (!name.ends_with(kTemporary)) return false;
    const std::size_t count = name.rfind('.', name.size() - kTemporary.size() - 1);
    const std::size_t process = count == std::string::npos ? count : name.rfind('.', count - 1);
    if (process == std::string::npos || !name.substr(0, process).ends_with("." + hostName())) return false;
    pid_t id = 0;
    std::from_chars(name.data() + process + 1, name.data() + count, id);
    return id > 0 && kill(id, 0) != 0 && errno == ESRCH;
}

// A folder entry is on disk only when its folder is.
void syncFolder(const Path& folder) {
    const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    fsync(file);
    close(file);
}

}  // namespace

void writeDurably(const Path& file, std::string_view text) {
    const Path part = file.parent_path() / temporaryName(file.filename().string());
    const int out = open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (out < 0) fail(file, errno);
    int error = 0;
    while (error == 0 && !text.empty()) {
        const ssize_t written = write(out, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) error = errno;
        else text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (error == 0 && fsync(out) != 0) error = errno;
    if (close(out) != 0 && error == 0) error = errno;
    if (error == 0 && rename(part.c_str(), file.c_str()) != 0) error = errno;
    if (error != 0) {
        unlink(part.c_str());
        // Another process has finished the same piece and has cleaned up: the same content is in its place.
        if (error == ENOENT && std::filesystem::exists(file)) return;
        fail(file, error);
    }
    syncFolder(file.parent_path());
}

void removeLeftovers(const Path& folder) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        std::error_code ignored;
        if (isLeftover(entry.path().filename().string())) std::filesystem::remove(entry.path(), ignored);
    }
}

}  // namespace tread
