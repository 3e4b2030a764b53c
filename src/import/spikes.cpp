#include "import/spikes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tread {
namespace {

constexpr std::size_t kLongest = 3;          // samples: what takes longer may be the car
constexpr std::size_t kAround = 50;          // samples on either side that show the usual change
constexpr std::size_t kSwitchValues = 16;    // a channel with no more values is a switch or a counter
constexpr double kShareOfRange = 0.1;        // smaller excursions harm nobody
constexpr double kUsual = 0.9;               // share of the changes around that a spike does not belong to
constexpr double kSigmaOfUsual = 1 / 1.645;  // standard deviation over that quantile of its magnitude, normal noise
constexpr double kReturns = 0.5;             // behind a spike the channel is back within this share of its height

double quantile(std::vector<double>& values, double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

bool isSwitch(const std::vector<double>& values) {
    std::set<double> different;
    for (const double value : values) {
        if (std::isfinite(value) && different.insert(value).second && different.size() > kSwitchValues) return false;
    }
    return true;
}

double range(const std::vector<double>& values) {
    std::vector<double> finite;
    std::copy_if(values.begin(), values.end(), std::back_inserter(finite), [](double v) { return std::isfinite(v); });
    return finite.empty() ? 0 : quantile(finite, 0.99) - quantile(finite, 0.01);
}

double usualChange(const std::vector<double>& values, std::size_t around) {
    std::vector<double> changes;
    const std::size_t first = around > kAround ? around - kAround : 1;
    for (std::size_t i = std::max<std::size_t>(first, 1); i < std::min(values.size(), around + kAround); ++i) {
        const double change = std::abs(values[i] - values[i - 1]);
        if (std::isfinite(change)) changes.push_back(change);
    }
    return changes.empty() ? 0 : kSigmaOfUsual * quantile(changes, kUsual);
}

double between(const std::vector<double>& time, const std::vector<double>& values, std::size_t left, std::size_t right,
               std::size_t at) {
    const double share = (time[at] - time[left]) / (time[right] - time[left]);
    return values[left] + share * (values[right] - values[left]);
}

// Whether the samples between left and right all lie to one side of the line between the two, by more than `height`.
bool isSpike(const std::vector<double>& time, const std::vector<double>& values, std::size_t left, std::size_t right,
             double height) {
    const double side = values[left + 1] > values[left] ? 1 : -1;
    double lowest = 0;
    for (std::size_t i = left + 1; i < right; ++i) {
        const double above = side * (values[i] - between(time, values, left, right, i));
        if (!(above > height)) return false;
        lowest = i == left + 1 ? above : std::min(lowest, above);
    }
    return std::abs(values[right] - values[left]) < kReturns * lowest;
}

}  // namespace

std::vector<std::size_t> replaceSpikes(const std::vector<double>& time, std::vector<double>& values, double limit) {
    std::vector<std::size_t> replaced;
    if (isSwitch(values)) return replaced;
    const double smallest = kShareOfRange * range(values);
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        if (!(std::abs(values[i] - values[i - 1]) > smallest)) continue;
        const double height = std::max(smallest, limit * usualChange(values, i));
        for (std::size_t right = i + 1; right < std::min(values.size(), i + 1 + kLongest); ++right) {
            if (!std::isfinite(values[right]) || !isSpike(time, values, i - 1, right, height)) continue;
            for (std::size_t k = i; k < right; ++k) {
                values[k] = between(time, values, i - 1, right, k);
                replaced.push_back(k);
            }
            break;
        }
    }
    return replaced;
}

std::size_t fillHoles(const std::vector<double>& time, std::vector<double>& values, double longest) {
    std::size_t filled = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (std::isfinite(values[i]) || !std::isfinite(values[i - 1])) continue;
        std::size_t right = i;
        while (right < values.size() && !std::isfinite(values[right])) ++right;
        const std::size_t left = i - 1;
        if (right < values.size() && time[right] - time[left] <= longest) {
            for (; i < right; ++i, ++filled) values[i] = between(time, values, left, right, i);
        }
        i = right;
    }
    return filled;
}

}  // namespace tread
