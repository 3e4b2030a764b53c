// The middle of many numbers: what a few wild ones do not move.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace tread {

// Of those that are finite; of an even count the mean of the two in the middle, of none 0.
inline double median(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return 0;
    const auto upper = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), upper, values.end());
    if (values.size() % 2 == 1) return *upper;
    return 0.5 * (*std::max_element(values.begin(), upper) + *upper);
}

// The usual distance of neighbouring times; 0 for fewer than two.
inline double medianStep(std::span<const double> time) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
    return median(std::move(steps));
}

}  // namespace tread
