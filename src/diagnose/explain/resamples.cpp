#include "diagnose/explain/resamples.h"

#include <algorithm>

namespace tread::diagnose::explain {

std::pair<double, double> ninetyPercentInterval(double share, std::vector<double> samples) {
    if (samples.empty()) return {share, share};
    std::sort(samples.begin(), samples.end());
    const auto at = [&](double quantile) {
        return samples[static_cast<std::size_t>(quantile * static_cast<double>(samples.size() - 1))];
    };
    return {std::min(at(0.05), share), std::max(at(0.95), share)};
}

}  // namespace tread::diagnose::explain
