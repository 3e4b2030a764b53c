#include "recording/checks/windows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/math/median.h"
#include "tread/describe.h"

namespace tread::recording::checks {
namespace {

constexpr double kWindow = 0.2;      // s; a longer one hides short delays, a shorter one passes more noise of rates
constexpr double kBlockStep = 0.02;  // s, least length of a block

}  // namespace

Windows::Windows(std::vector<double> time) : time_(std::move(time)) {
    const double interval = std::max(medianStep(time_), 1e-4);
    step_ = std::max(kBlockStep, interval);
    samples_per_block_ = step_ / interval;
    count_ = static_cast<std::size_t>((time_.back() - time_.front()) / step_) + 1;
    length_ = std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(kWindow / step_)));
}

std::vector<double> Windows::blocks(std::span<const double> values, double delay) const {
    std::vector<double> sums(count_, 0), counts(count_, 0);
    for (std::size_t i = 0; i < time_.size(); ++i) {
        // Half an interval keeps samples off the boundaries of the blocks.
        const double at = std::floor((time_[i] - time_.front() - delay) / step_ + 0.5 / samples_per_block_);
        if (!(at >= 0) || at >= static_cast<double>(count_) || !std::isfinite(values[i])) continue;
        sums[static_cast<std::size_t>(at)] += values[i];
        counts[static_cast<std::size_t>(at)] += 1;
    }
    for (std::size_t b = 0; b < count_; ++b) sums[b] = counts[b] > 0 ? sums[b] / counts[b] : kRequired;
    return sums;
}

std::vector<double> Windows::mean(std::span<const double> blocks) const {
    std::vector<double> means(blocks.size(), kRequired);
    for (std::size_t k = 1; k + length_ < blocks.size(); ++k) {
        const auto window = blocks.subspan(k, length_);
        means[k] = std::accumulate(window.begin(), window.end(), 0.0) / static_cast<double>(length_);
    }
    return means;
}

std::vector<double> Windows::rate(std::span<const double> blocks) const {
    std::vector<double> rates(blocks.size(), kRequired);
    const double seconds = static_cast<double>(length_) * step_;
    // The value at the end of a window is the mean of the blocks on either side of it.
    for (std::size_t k = 1; k + length_ < blocks.size(); ++k)
        rates[k] = 0.5 * (blocks[k + length_ - 1] + blocks[k + length_] - blocks[k - 1] - blocks[k]) / seconds;
    return rates;
}

double Windows::noise(double of_block, bool of_rate) const {
    const auto length = static_cast<double>(length_);
    return of_rate ? of_block / (length * step_) : of_block / std::sqrt(length);
}

}  // namespace tread::recording::checks
