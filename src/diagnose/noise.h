// How noisy the rows of the recordings are.
#pragma once

#include "diagnose/bench.h"

namespace tread {

// Per drive. `deviation` is the standard deviation of each row that is white noise: what the file tells of the
// instrument, and not less than what the recordings show between 2 and 7 Hz that the model does not explain. Vibration
// lies above that and hides nothing; with it, a perfect model leaves `expected` squared deviations.
struct RowNoise {
    Eigen::VectorXd deviation;
    double expected = 0;
};
std::vector<RowNoise> rowNoise(const std::vector<RecordedDrive>& drives, const Rows& nominal);

}  // namespace tread
