// Cache of sensitivities on disk. An interrupted diagnosis resumes where it stopped, and a second one of the same car
// and drives need not replay them again. Cached values are identical to computed ones, to the bit.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

// Folder for the columns of one drive of one subject. It is named by a hash of everything on which the columns depend:
// the numbers of the nominal car and of the subject, the recording, the time step and the program itself. Empty when
// nothing is cached.
std::filesystem::path columnFolder(const Replays& replays, const RecordedDrive& drive, const Subject& subject);

struct DrivenColumn {
    std::optional<Eigen::VectorXd> values;
    int simulations = 0;  // that it took
};

// The column of a parameter for the step `by` (in its units), read from the folder; if it is not there, computed by
// `make` and stored. An incomplete file counts as missing, and failing to write one is not an error.
DrivenColumn keptColumn(const std::filesystem::path& folder, const Parameter& parameter, double by, Eigen::Index rows,
                        const std::function<DrivenColumn()>& make);

// Bytes that a cache may hold: 1 GB, or as many as the variable TREAD_LARGEST_CACHE says. Throws LoadError when that
// is no number.
std::uintmax_t largestCache();

// Removes the columns that have not been used for longest until the rest is within `most` bytes. keptColumn() does so
// whenever a process has added an eighth of the limit.
void trimCache(const std::filesystem::path& cache, std::uintmax_t most);

}  // namespace tread::diagnose::model
