#include "store/claims.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "store/whole_file.h"

namespace tread {
namespace {

struct flock lockOf(std::uint64_t piece, short type) {
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = static_cast<off_t>(piece);
    lock.l_len = 1;
    return lock;
}

}  // namespace

Claims::Claims(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "claims";
    file_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) {
        throw FileError(fmt::format("cannot write '{}': {}", file.string(), std::generic_category().message(errno)));
    }
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

std::vector<std::uint64_t> claimed(const std::filesystem::path& folder, std::uint64_t pieces) {
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

}  // namespace tread
