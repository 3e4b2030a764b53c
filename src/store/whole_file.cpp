#include "store/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

namespace tread {
namespace {

using Path = std::filesystem::path;

constexpr std::string_view kTemporary = ".tread.part";
constexpr std::size_t kFlushBytes = 1 << 16;
constexpr std::size_t kLongestStem = 150;  // of a temporary name, which has 255 bytes: 64 are for the machine
constexpr int kMostLinks = 40;             // as Linux follows

// What a signal interrupts is called again.
auto again(const auto& call) {
    auto result = call();
    while (result < 0 && errno == EINTR) result = call();
    return result;
}

std::string hostName() {
    char host[65] = "";
    gethostname(host, sizeof host - 1);
    return host;
}

// Unique among the processes of all machines that share the folder.
std::string temporaryName(const std::string& name) {
    static std::atomic<unsigned> count{0};
    return fmt::format("{}.{}.{}.{}{}", name.substr(0, kLongestStem), hostName(), getpid(), count++, kTemporary);
}

// Machine and process that made a temporary file; no process: the file is none.
struct Maker {
    std::string host;
    pid_t process = 0;
};

Maker makerOf(const std::string& name) {
    if (!name.ends_with(kTemporary)) return {};
    constexpr auto kNowhere = std::string::npos;
    const std::size_t count = name.rfind('.', name.size() - kTemporary.size() - 1);
    const std::size_t process = count == kNowhere || count == 0 ? kNowhere : name.rfind('.', count - 1);
    if (process == kNowhere) return {};
    Maker maker{name.substr(0, process)};
    std::from_chars(name.data() + process + 1, name.data() + count, maker.process);
    return maker;
}

enum class Lock { mine, of_another, impossible };  // impossible: on file systems without locks

Lock lock(int file) {
    if (again([&] { return flock(file, LOCK_EX | LOCK_NB); }) == 0) return Lock::mine;
    return errno == EWOULDBLOCK ? Lock::of_another : Lock::impossible;
}

// On some shared file systems, a lock counts only on the machine that took it. What another machine has changed less
// than an hour ago may therefore still be in the making, even if its lock can be taken.
bool isOld(const Path& file) {
    std::error_code error;
    const auto changed = std::filesystem::last_write_time(file, error);
    return !error && std::filesystem::file_time_type::clock::now() - changed > std::chrono::hours(1);
}

// Removes a temporary file when the process that made it has ended: it held a lock until then, which whoever removes
// the file holds in its place. Without locks only processes of this machine can be asked.
void removeIfLeft(const Path& file) {
    const Maker maker = makerOf(file.filename().string());
    if (maker.process <= 0) return;
    const int part = open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (part < 0) return;
    const bool of_this_machine = maker.host.ends_with("." + hostName());
    bool has_ended = false;
    switch (lock(part)) {
        case Lock::mine:
            has_ended = of_this_machine || isOld(file);
            break;
        case Lock::of_another:
            break;
        case Lock::impossible:
            has_ended = of_this_machine && kill(maker.process, 0) != 0 && errno == ESRCH;
            break;
    }
    if (has_ended) unlink(file.c_str());
    close(part);
}

// A folder entry is on disk only when its folder is.
void syncFolder(const Path& folder) {
    const int file = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    fsync(file);
    close(file);
}

void removeLeftoversOnce(const Path& folder) {
    static std::mutex guard;
    static std::set<Path> seen;
    const std::lock_guard locked(guard);
    if (seen.insert(folder).second) removeLeftovers(folder);
}

// The file that links lead to; it need not exist.
Path withoutLinks(Path file) {
    std::error_code error;
    for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(std::filesystem::symlink_status(file, error)); ++i) {
        const Path to = std::filesystem::read_symlink(file, error);
        if (error) break;
        file = file.parent_path() / to;
    }
    return file;
}

}  // namespace

WholeFile::WholeFile(Path file) : name_(std::move(file)), target_(withoutLinks(name_)) {
    struct stat status {};
    const bool exists = !name_.empty() && stat(target_.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail(EISDIR, name_);
    if (name_.empty() || (exists && !S_ISREG(status.st_mode))) {
        openDirectly();
        return;
    }
    if (exists && faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno, name_);
    removeLeftoversOnce(target_.parent_path());
    openPart();
    if (exists) fchmod(file_, status.st_mode & 07777);
}

WholeFile::~WholeFile() {
    if (!part_.empty()) unlink(part_.c_str());
    close();
}

void WholeFile::openDirectly() {
    file_ = name_.empty() ? STDOUT_FILENO : again([&] { return open(target_.c_str(), O_WRONLY | O_CLOEXEC); });
    if (file_ < 0) fail(errno, name_);
}

// The lock tells other processes that this one lives. One that looks for leftovers may come between making the file and
// locking it: then another file is made.
void WholeFile::openPart() {
    for (;;) {
        const Path part = target_.parent_path() / temporaryName(target_.filename().string());
        file_ = again([&] { return open(part.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
        if (file_ < 0 && errno == EEXIST) continue;
        if (file_ < 0) fail(errno, name_);
        struct stat status {};
        if (lock(file_) != Lock::of_another && fstat(file_, &status) == 0 && status.st_nlink > 0) {
            part_ = part;
            return;
        }
        close();
    }
}

void WholeFile::write(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() >= kFlushBytes) flush();
}

void WholeFile::flush() {
    std::string_view rest = buffer_;
    int error = 0;
    while (error == 0 && !rest.empty()) {
        const ssize_t taken = again([&] { return ::write(file_, rest.data(), rest.size()); });
        if (taken < 0) {
            error = errno;
        } else {
            rest.remove_prefix(static_cast<std::size_t>(taken));
            written_ += static_cast<std::uintmax_t>(taken);
        }
    }
    buffer_.clear();
    if (error != 0) fail(error, name_);
}

// The content must be on disk before the file gets its name: some file systems report a full disk only here.
void WholeFile::finish() {
    flush();
    if (part_.empty()) return close();
    if (again([&] { return fsync(file_); }) != 0) fail(errno, name_);
    nameIt(target_);
}

void WholeFile::keepAs(const Path& other, std::uintmax_t bytes) {
    buffer_.clear();
    if (again([&] { return ftruncate(file_, static_cast<off_t>(bytes)); }) != 0) fail(errno, name_);
    fsync(file_);  // as far as a full disk allows
    nameIt(other);
}

// The file is closed, and its lock freed, when it has its name.
void WholeFile::nameIt(const Path& name) {
    if (again([&] { return std::rename(part_.c_str(), name.c_str()); }) != 0)
        fail(errno, name == target_ ? name_ : name);
    part_.clear();
    close();
    syncFolder(name.parent_path());
}

void WholeFile::close() {
    if (file_ >= 0 && file_ != STDOUT_FILENO) ::close(file_);
    file_ = -1;
}

void WholeFile::fail(int error, const Path& name) const {
    const std::string where = name.empty() ? "the answer to standard output" : "'" + name.string() + "'";
    throw FileError(fmt::format("cannot write {}: {}", where, std::generic_category().message(error)));
}

void writeFile(const Path& file, std::string_view text) {
    WholeFile out(file);
    out.write(text);
    out.finish();
}

void removeLeftovers(const Path& folder) {
    std::error_code error;
    std::filesystem::directory_iterator entry(folder.empty() ? Path(".") : folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
        removeIfLeft(entry->path());
}

}  // namespace tread
