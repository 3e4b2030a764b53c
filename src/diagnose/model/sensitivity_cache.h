// Sensitivities kept on disk, so that a diagnosis that was interrupted goes on where it stopped, and a second one of
// the same car and drives need not drive them again. What is taken from there is what was computed, to the bit.
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "diagnose/model/replays.h"

namespace tread::diagnose::model {

// Where the columns of one drive of one subject are kept: a folder named by a hash of everything on which they depend,
// the subject's numbers, the recording, the time step and the program itself. Empty when nothing is kept.
std::filesystem::path columnFolder(const Replays& replays, const RecordedDrive& drive, const Subject& subject);

// The column of a parameter and steps to both sides (in its units) as it is kept in the folder; otherwise as it is made
// now, and then kept. A file that cannot be read in full counts as none; one that cannot be written is not missed.
std::optional<Eigen::VectorXd> keptColumn(const std::filesystem::path& folder, const Parameter& parameter, double by,
                                          Eigen::Index rows,
                                          const std::function<std::optional<Eigen::VectorXd>()>& make);

}  // namespace tread::diagnose::model
