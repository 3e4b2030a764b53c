// Estimation of the noise of evenly spaced rows, and the filter after which it counts as white.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <span>
#include <vector>

namespace tread::inference {

// Filter that removes slow changes: it annihilates parabolas.
inline constexpr std::array<double, 4> kThirdDifference{1, -3, 3, -1};

// Filter that passes 2 to 7 Hz of rows 50 ms apart.
inline constexpr std::array<double, 6> kBand{1, 1, -2, -2, 1, 1};

// Standard deviation of white noise that would leave such values behind the filter. It is robust because it uses the
// median of the absolute values: rare events do not count as noise. Gaps are left out; 0 when nothing is left (D7).
double noiseBehind(std::span<const double> values, std::span<const double> filter);

// Share of the variance of white noise that binomial() leaves (D10).
inline constexpr double kLeftByBinomial = 0.375;

// Each row averaged with its neighbours (1/4, 1/2, 1/4) within its channel; `ends` are the indices behind the last row
// of each channel. Slow signals pass unchanged; of 8 Hz in rows 50 ms apart a tenth of the amplitude is left (D9).
Eigen::MatrixXd binomial(const Eigen::MatrixXd& rows, const std::vector<Eigen::Index>& ends);

}  // namespace tread::inference
