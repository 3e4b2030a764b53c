// What the files of one load have in common: the file itself and all that it includes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "tread/problem.h"

namespace tread {

// Nobody reads more problems than this; a hostile file could have millions.
inline constexpr std::size_t kMostProblems = 1000;

struct YamlSession {
    std::vector<Problem> problems;
    std::vector<std::filesystem::path> open_files;  // being read, outermost first
    int files_read = 0;
    // Fields that no file gave were filled by other means (a foreign file, an option): check their limits, too.
    bool check_absent = false;
};

// Keeps a file among those being read, so that a circle of includes is noticed.
class OpenFile {
public:
    OpenFile(YamlSession& session, const std::filesystem::path& file);
    ~OpenFile() { session_.open_files.pop_back(); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

private:
    YamlSession& session_;
};

// Adds faults that were found in what had been read; not those of values that were faulty already in the file.
void addFurther(std::vector<Problem>& problems, std::vector<Problem> further);

// Sorts by position within each file, drops repetitions, throws when anything is left.
void throwIfAny(std::vector<Problem> problems);

}  // namespace tread
