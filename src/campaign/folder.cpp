#include "campaign/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <system_error>

#include "base/number_text.h"
#include "base/trimmed.h"
#include "log/csv.h"
#include "tread/problem.h"

namespace tread::campaign {
namespace {

constexpr std::string_view kTemporary = ".tmp";

[[noreturn]] void fail(const Path& file, int error) {
    throw FileError(fmt::format("cannot write '{}': {}", file.string(), std::generic_category().message(error)));
}

struct flock lockOf(std::uint64_t piece, short type) {
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = static_cast<off_t>(piece);
    lock.l_len = 1;
    return lock;
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

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        lines.push_back(text.substr(0, end + (text[end] == '\n' ? 0 : 1)));
        text.remove_prefix(end + 1);
    }
    return lines;
}

// The keys and list elements that enclose a line of a YAML text, by their indentation: "vehicles: vehicle: mass".
std::string placeOf(const std::vector<std::string_view>& lines, std::size_t line) {
    std::string place;
    std::size_t limit = std::string_view::npos;
    for (std::size_t i = line + 1; i-- > 0 && limit != 0;) {
        const std::size_t indent = lines[i].find_first_not_of(" -");
        if (indent == std::string_view::npos || indent >= limit) continue;
        const std::string_view key = trimmed(lines[i].substr(indent));
        const std::size_t colon = key.find(':');
        limit = indent;
        if (i == line || colon == std::string_view::npos) continue;
        place = std::string(key.substr(0, colon)) + (place.empty() ? "" : ".") + place;
    }
    return place;
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

Claims::Claims(const Path& folder) {
    const Path file = folder / "claims";
    file_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) fail(file, errno);
}

Claims::~Claims() {
    close(file_);
}

bool Claims::take(std::uint64_t piece) {
    struct flock lock = lockOf(piece, F_WRLCK);
    if (fcntl(file_, F_OFD_SETLK, &lock) == 0) return true;
    return errno != EAGAIN && errno != EACCES;
}

void Claims::release(std::uint64_t piece) {
    struct flock lock = lockOf(piece, F_UNLCK);
    fcntl(file_, F_OFD_SETLK, &lock);
}

std::vector<std::uint64_t> claimed(const Path& folder, std::uint64_t pieces) {
    std::vector<std::uint64_t> found;
    const int file = open((folder / "claims").c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) return found;
    for (std::uint64_t piece = 0; piece < pieces;) {
        struct flock lock = lockOf(piece, F_WRLCK);
        lock.l_len = static_cast<off_t>(pieces - piece);
        if (fcntl(file, F_OFD_GETLK, &lock) != 0 || lock.l_type == F_UNLCK) break;
        const auto begin = static_cast<std::uint64_t>(lock.l_start);
        const std::uint64_t end = begin + static_cast<std::uint64_t>(lock.l_len);
        for (piece = std::max(piece, begin); piece < std::min(end, pieces); ++piece) found.push_back(piece);
    }
    close(file);
    return found;
}

Path inputsFile(const Path& folder) {
    return folder / "inputs.yaml";
}

Path pieceFile(const Path& folder, const Plan& plan, std::uint64_t piece) {
    const std::uint64_t first = plan.firstOf(piece);
    return folder / "pieces" / fmt::format("{:09}-{:09}.piece", first, first + plan.countOf(piece) - 1);
}

void openFolder(const Path& folder, const Plan& plan) {
    std::error_code error;
    std::filesystem::create_directories(folder / "pieces", error);
    if (error) {
        throw FileError(
            fmt::format("cannot create the folder {}: {}; choose another with -o", folder.string(), error.message()));
    }
    const Path file = inputsFile(folder);
    if (std::filesystem::exists(file)) {
        const std::string before = readBytes(file);
        if (before == plan.identity) return;
        throw LoadError({{file.string(), 0, 0, "",
                          "found the results of another campaign: " + firstDifference(before, plan.identity) +
                              "; choose another folder with -o, or remove this one"}});
    }
    if (std::filesystem::exists(folder / "results.csv")) {
        throw LoadError({{folder.string(), 0, 0, "",
                          "found results without inputs.yaml, expected an empty folder; choose another with -o"}});
    }
    writeDurably(file, plan.identity);
}

std::string firstDifference(std::string_view before, std::string_view now) {
    const std::vector<std::string_view> old_lines = linesOf(before), new_lines = linesOf(now);
    for (std::size_t i = 0; i < std::max(old_lines.size(), new_lines.size()); ++i) {
        const std::string_view had = i < old_lines.size() ? old_lines[i] : "";
        const std::string_view has = i < new_lines.size() ? new_lines[i] : "";
        if (had == has) continue;
        const std::string place = i < new_lines.size() ? placeOf(new_lines, i) : placeOf(old_lines, i);
        return fmt::format("{}it has {} in line {}, this one has {}", place.empty() ? "" : "in " + place + " ",
                           had.empty() ? "nothing" : quote(trimmed(had)), i + 1,
                           has.empty() ? "nothing" : quote(trimmed(has)));
    }
    return {};
}

std::vector<bool> piecesPresent(const Path& folder, const Plan& plan) {
    std::vector<bool> present(plan.pieces());
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "pieces", error)) {
        const std::string name = entry.path().filename().string();
        std::uint64_t first = 0;
        std::from_chars(name.data(), name.data() + name.size(), first);
        if (first >= plan.runs || first % plan.runs_per_piece != 0) continue;
        const std::uint64_t piece = first / plan.runs_per_piece;
        if (name == pieceFile(folder, plan, piece).filename()) present[piece] = true;
    }
    return present;
}

void removeLeftovers(const Path& folder) {
    for (const Path& place : {folder, folder / "pieces", folder / "logs"}) {
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(place, error)) {
            std::error_code ignored;
            if (isLeftover(entry.path().filename().string())) std::filesystem::remove(entry.path(), ignored);
        }
    }
}

}  // namespace tread::campaign
