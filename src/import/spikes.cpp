#include "import/spikes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace tread {
namespace {

constexpr std::size_t kLongest = 3;            // samples, unless the car cannot jump like that
constexpr std::size_t kAround = 50;            // samples on either side that show the usual change
constexpr std::size_t kSwitchValues = 16;      // a channel with no more values is a switch or a counter
constexpr double kUsual = 0.9;                 // share of the changes around that a spike does not belong to
constexpr double kSigmaOfUsual = 1 / 1.645;    // standard deviation over that quantile of its magnitude, normal noise
constexpr double kSigmaOfMedian = 1 / 0.6745;  // the same over the median
constexpr double kLongestHold = 0.1;           // s: the slowest instruments of a car send ten times a second
constexpr double kStillAway = 0.25;            // share of the height of a jump below which a channel is back
constexpr double kStandsStill = 0.01;          // share of the height of a jump by which a dead channel moves
constexpr double kReturns = 0.5;               // behind a spike the channel is back within this share of its height

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

// For how long the values of a channel that is updated less often than it is logged stay the same: the usual length of
// a run of equal values. A channel that hardly moves has long runs, but no instrument is that slow.
double heldFor(const std::vector<double>& time, const std::vector<double>& values) {
    std::vector<double> runs;
    std::size_t begin = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (values[i] == values[begin]) continue;
        runs.push_back(time[i] - time[begin]);
        begin = i;
    }
    return runs.empty() ? 0 : std::min(quantile(runs, 0.5), kLongestHold);
}

// Jumps that no car can do, and back.
class Excursions {
public:
    Excursions(const std::vector<double>& time, std::vector<double>& values, const SpikeCriterion& criterion)
        : time_(time), values_(values), criterion_(criterion), held_(heldFor(time, values)) {}

    void replace(std::vector<std::size_t>& replaced) {
        std::size_t left = values_.size();  // the last sample that is believed
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (!std::isfinite(values_[i])) continue;
            if (left < i && isJump(left, i)) {
                if (const std::size_t right = endOf(left, i); right < values_.size() && isNoDrive(left, right)) {
                    bridge(left, right, replaced);
                    i = right;
                }
            }
            left = i;
        }
    }

private:
    // Noise is what most samples around change by; a cluster of spikes is not most of them.
    double reach(std::size_t from, std::size_t to) const {
        return criterion_.fastest * std::max(time_[to] - time_[from], held_) + criterion_.limit * noiseAround(to);
    }

    double noiseAround(std::size_t around) const {
        std::vector<double> changes;
        const std::size_t first = around > kAround ? around - kAround : 1;
        for (std::size_t i = std::max<std::size_t>(first, 1); i < std::min(values_.size(), around + kAround); ++i) {
            const double change = std::abs(values_[i] - values_[i - 1]);
            if (std::isfinite(change)) changes.push_back(change);
        }
        return changes.empty() ? 0 : kSigmaOfMedian * quantile(changes, 0.5);
    }

    bool isJump(std::size_t from, std::size_t to) const {
        const double jump = std::abs(values_[to] - values_[from]);
        return jump > criterion_.fastest * std::max(time_[to] - time_[from], held_) && jump > reach(from, to);
    }

    // The sample at which the channel has jumped back; the number of samples when it comes back slowly or never.
    std::size_t endOf(std::size_t left, std::size_t begin) const {
        const std::size_t none = values_.size(), last = std::min(none, begin + none / 2);
        const double height = std::abs(values_[begin] - values_[left]);
        std::size_t before = begin;
        for (std::size_t i = begin + 1; i < last; ++i) {
            if (!std::isfinite(values_[i])) continue;
            const double away = std::abs(values_[i] - values_[left]);
            if (away < kReturns * height) {
                const double back = std::abs(values_[i] - values_[before]);
                if (back > kReturns * height && isJump(before, i)) return i;
                if (away < kStillAway * height) return none;
            }
            before = i;
        }
        return none;
    }

    bool isNoDrive(std::size_t left, std::size_t right) const {
        if (time_[right] - time_[left] <= criterion_.longest) return true;
        double least = std::numeric_limits<double>::infinity(), most = -least, nearest = least;
        for (std::size_t k = left + 1; k < right; ++k) {
            if (!std::isfinite(values_[k])) continue;
            least = std::min(least, values_[k]);
            most = std::max(most, values_[k]);
            nearest = std::min(nearest, std::abs(values_[k]));
        }
        const bool stands = most - least < kStandsStill * std::abs(values_[left + 1] - values_[left]);
        return stands || nearest > criterion_.largest;
    }

    void bridge(std::size_t left, std::size_t right, std::vector<std::size_t>& replaced) {
        const bool fills = time_[right] - time_[left] <= criterion_.longest;
        for (std::size_t k = left + 1; k < right; ++k) {
            if (!std::isfinite(values_[k])) continue;
            values_[k] = fills ? between(time_, values_, left, right, k) : std::numeric_limits<double>::quiet_NaN();
            replaced.push_back(k);
        }
    }

    const std::vector<double>& time_;
    std::vector<double>& values_;
    const SpikeCriterion& criterion_;
    double held_;
};

void replaceShort(const std::vector<double>& time, std::vector<double>& values, const SpikeCriterion& criterion,
                  std::vector<std::size_t>& replaced) {
    const double longest =
        std::isfinite(criterion.fastest) ? std::min(kThereAndBack, criterion.within) : criterion.within;
    const double smallest = criterion.least * range(values);
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        if (!(std::abs(values[i] - values[i - 1]) > smallest)) continue;
        const double height = std::max(smallest, criterion.limit * usualChange(values, i));
        for (std::size_t right = i + 1; right < std::min(values.size(), i + 1 + kLongest); ++right) {
            if (time[right] - time[i - 1] > longest) break;
            if (!std::isfinite(values[right]) || !isSpike(time, values, i - 1, right, height)) continue;
            for (std::size_t k = i; k < right; ++k) {
                values[k] = between(time, values, i - 1, right, k);
                replaced.push_back(k);
            }
            break;
        }
    }
}

}  // namespace

std::vector<std::size_t> replaceSpikes(const std::vector<double>& time, std::vector<double>& values,
                                       const SpikeCriterion& criterion) {
    std::vector<std::size_t> replaced;
    if (std::isfinite(criterion.fastest)) Excursions(time, values, criterion).replace(replaced);
    if (isSwitch(values)) return replaced;
    replaceShort(time, values, criterion, replaced);
    std::sort(replaced.begin(), replaced.end());
    replaced.erase(std::unique(replaced.begin(), replaced.end()), replaced.end());
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
