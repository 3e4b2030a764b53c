// How noisy the rows of the recordings are.
#pragma once

#include <array>
#include <span>

#include "diagnose/bench.h"

namespace tread {

// A filter that leaves nothing of what is slow in evenly spaced values.
inline constexpr std::array<double, 4> kThirdDifference{1, -3, 3, -1};

// Standard deviation of the white noise that would leave what is behind the filter, by the median: what happens now and
// then is not noise. Gaps are left out; 0 when nothing is left.
double noiseBehind(std::span<const double> values, std::span<const double> filter);

// Per drive. `deviation` is the standard deviation of each row that is white noise: what the file tells of the
// instrument, and not less than what the recordings show between 2 and 7 Hz that the model does not explain. Vibration
// lies above that and hides nothing; with it, a perfect model leaves `expected` squared deviations.
struct RowNoise {
    Eigen::VectorXd deviation;
    double expected = 0;
};
std::vector<RowNoise> rowNoise(const std::vector<RecordedDrive>& drives, const Rows& nominal);

}  // namespace tread
