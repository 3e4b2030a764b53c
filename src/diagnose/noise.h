// How noisy the rows of the recordings are.
#pragma once

#include "diagnose/bench.h"

namespace tread {

// Per drive the standard deviation of each row: what the file tells of the instrument, and not less than what the
// recordings show at the highest frequencies, less what the model explains there.
std::vector<Eigen::VectorXd> rowNoise(const std::vector<RecordedDrive>& drives, const Rows& nominal);

}  // namespace tread
