// Cache of sensitivities on disk. An interrupted diagnosis resumes where it stopped, and a second one of the same car
// and drives need not replay them again. Cached values are identical to computed ones, to the bit.
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

// Folder for the columns of one drive of one subject. It is named by a hash of everything on which the columns depend:
// the numbers of the nominal car and of the subject, the recording, the time step and the program itself. Empty when
// nothing is cached.
std::filesystem::path columnFolder(const Replays& replays, const RecordedDrive& drive, const Subject& subject);

// The column of a parameter for the step `by` (in its units), read from the folder; if it is not there, computed by
// `make` and stored. An incomplete file counts as missing, and failing to write one is not an error.
std::optional<Eigen::VectorXd> keptColumn(const std::filesystem::path& folder, const Parameter& parameter, double by,
                                          Eigen::Index rows,
                                          const std::function<std::optional<Eigen::VectorXd>()>& make);

}  // namespace tread::diagnose::model
