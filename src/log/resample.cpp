#include "log/resample.h"

#include <algorithm>
#include <limits>

namespace tread {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

// `right` is the first sample at or after t.
double between(std::span<const double> time, std::span<const double> values, std::size_t right, double t) {
    if (right == time.size()) return kNoValue;
    if (time[right] == t) return values[right];
    if (right == 0) return kNoValue;
    const double share = (t - time[right - 1]) / (time[right] - time[right - 1]);
    return values[right - 1] + share * (values[right] - values[right - 1]);
}

}  // namespace

double valueAt(std::span<const double> time, std::span<const double> values, double t) {
    const auto right = std::lower_bound(time.begin(), time.end(), t) - time.begin();
    return between(time, values, static_cast<std::size_t>(right), t);
}

std::vector<double> resample(std::span<const double> time, std::span<const double> values, std::span<const double> at) {
    std::vector<double> out;
    out.reserve(at.size());
    std::size_t right = 0;
    for (const double t : at) {
        while (right < time.size() && time[right] < t) ++right;
        out.push_back(between(time, values, right, t));
    }
    return out;
}

}  // namespace tread
