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

// Of one drive. `deviation` is the standard deviation of each row that is white noise: what the file tells of the
// instrument, and not less than what the recordings show between 2 and 7 Hz that the model does not explain. Above that
// engine and road shake the instruments: the faster a deviation, the less it says. Rows that say nothing are infinitely
// noisy.
struct RowNoise {
    Eigen::VectorXd deviation;
    std::vector<Eigen::Index> ends;  // of the rows of each channel
    double expected = 0;             // sum of squares that over() leaves of white noise

    // Columns of rows over their noise, in which white noise of deviation 1 is what is slow, and ten times what
    // vibrates at 8 Hz is no more than that: each row with half of its neighbours (binomial filter).
    Eigen::MatrixXd over(const Eigen::Ref<const Eigen::MatrixXd>& rows) const;
};
std::vector<RowNoise> rowNoise(const std::vector<RecordedDrive>& drives, const Rows& nominal);

}  // namespace tread
