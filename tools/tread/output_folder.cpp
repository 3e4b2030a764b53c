#include "output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include "store/result_folder.h"

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

// Whether another call holds the folder. Some file systems of networks know no locks: there it is used without one.
bool isHeld(int folder) {
    int locked = 0;
    do locked = flock(folder, LOCK_EX | (waits ? 0 : LOCK_NB));
    while (locked != 0 && errno == EINTR);
    return locked != 0 && errno == EWOULDBLOCK;
}

}  // namespace

void waitForFolders() {
    waits = true;
}

OutputFolder::OutputFolder(const Path& folder) : folder_(folder) {
    makeFolder(folder);
    held_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (held_ >= 0 && isHeld(held_)) {
        const long holder = holderOf(held_);
        close(held_);
        const std::string who = holder > 0 ? fmt::format("process {}", holder) : "another call";
        throw FileError(fmt::format("{} writes into the folder {}; choose another with -o, or wait for it with --wait",
                                    who, folder.string()));
    }
    try {
        markIncomplete(folder);
    } catch (...) {
        if (held_ >= 0) close(held_);
        throw;
    }
}

OutputFolder::~OutputFolder() {
    if (held_ >= 0) close(held_);
}

void OutputFolder::remove(const std::string& name) const {
    removeResult(folder_ / name);
}

void OutputFolder::complete() const {
    remove(kIncomplete);
}

}  // namespace tread::program
