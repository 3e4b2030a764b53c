// Intervals of shares from bootstrap samples of the drives.
#pragma once

#include <utility>
#include <vector>

namespace tread::diagnose::explain {

constexpr int kResamples = 400;  // for an interval

// The 90 % interval of a share from its values in the samples, widened where it would not hold the share; the share
// itself where there are no samples.
std::pair<double, double> ninetyPercentInterval(double share, std::vector<double> samples);

}  // namespace tread::diagnose::explain
