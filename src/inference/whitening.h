// Noise of evenly spaced rows, and rows in which it counts as white.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <span>
#include <vector>

namespace tread::inference {

// A filter that leaves nothing of what is slow in evenly spaced values.
inline constexpr std::array<double, 4> kThirdDifference{1, -3, 3, -1};

// A filter that passes 2 to 7 Hz of rows 50 ms apart.
inline constexpr std::array<double, 6> kBand{1, 1, -2, -2, 1, 1};

// Standard deviation of the white noise that would leave what is behind the filter. By the median of the absolute
// values: what happens now and then is not noise. Gaps are left out; 0 when nothing is left (D7).
double noiseBehind(std::span<const double> values, std::span<const double> filter);

// Share of the variance of white noise that binomial() leaves (D10).
inline constexpr double kLeftByBinomial = 0.375;

// Each row with half of its neighbours (1/4, 1/2, 1/4), by channel: `ends` are the rows behind the last one of each
// channel. What is slow stays as it is; what vibrates at 8 Hz of rows 50 ms apart is left to a tenth (D9).
Eigen::MatrixXd binomial(const Eigen::MatrixXd& rows, const std::vector<Eigen::Index>& ends);

}  // namespace tread::inference
