#include "output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include "log/csv.h"
#include "output.h"

namespace tread::program {
namespace {

bool waits = false;

// The process that holds a lock on the file, as Linux lists it; 0: not listed, as across machines.
long holderOf(int file) {
    struct stat status {};
    if (fstat(file, &status) != 0) return 0;
    std::ifstream locks("/proc/locks");
    const std::string inode = fmt::format(":{} ", status.st_ino);
    for (std::string line; std::getline(locks, line);) {
        if (line.find("FLOCK") == std::string::npos || line.find(inode) == std::string::npos) continue;
        std::istringstream words(line);
        std::string number, kind, advice, access;
        long process = 0;
        if (words >> number >> kind >> advice >> access >> process) return process;
    }
    return 0;
}

// Some file systems of networks know no locks: there the folder is used without one.
bool hasNoLocks(int error) {
    return error == ENOLCK || error == EOPNOTSUPP || error == ENOSYS || error == EINVAL;
}

}  // namespace

void waitForFolders() {
    waits = true;
}

OutputFolder::OutputFolder(const Path& folder) : folder_(folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw FileError(
            fmt::format("cannot create the folder {}: {}; choose another with -o", folder.string(), error.message()));
    }
    held_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (held_ >= 0 && flock(held_, LOCK_EX | (waits ? 0 : LOCK_NB)) != 0 && !hasNoLocks(errno)) {
        const long holder = holderOf(held_);
        close(held_);
        const std::string who = holder > 0 ? fmt::format("process {}", holder) : "another call";
        throw FileError(fmt::format("{} writes into the folder {}; choose another with -o, or wait for it with --wait",
                                    who, folder.string()));
    }
    try {
        writeFile(folder / kIncomplete,
                  "A call of tread is writing into this folder, or was killed while doing so: files may be missing or "
                  "from another run.\n");
    } catch (...) {
        if (held_ >= 0) close(held_);
        throw;
    }
}

OutputFolder::~OutputFolder() {
    if (held_ >= 0) close(held_);
}

void OutputFolder::remove(const std::string& name) const {
    std::error_code error;
    std::filesystem::remove(folder_ / name, error);
    if (error) {
        throw FileError(fmt::format("cannot remove {}, left by an earlier call: {}; choose another folder with -o",
                                    (folder_ / name).string(), error.message()));
    }
}

void OutputFolder::complete() const {
    remove(kIncomplete);
}

}  // namespace tread::program
