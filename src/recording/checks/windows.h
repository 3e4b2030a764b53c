// Means and rates of change of channels over windows of 0.2 s, such that the rate of a signal is exactly the mean of
// its derivative.
#pragma once

#include <span>
#include <vector>

namespace tread::recording::checks {

class Windows {
public:
    // `time`: times of the samples, increasing, s.
    explicit Windows(std::vector<double> time);

    double step() const { return step_; }  // s, between windows and between blocks

    // Means of the samples of each block, read `delay` s late; NaN for a block without finite samples.
    std::vector<double> blocks(std::span<const double> values, double delay = 0) const;

    // For each window: the mean of the blocks, and the rate of change between its ends.
    std::vector<double> mean(std::span<const double> blocks) const;
    std::vector<double> rate(std::span<const double> blocks) const;

    // Standard deviation that independent noise of the blocks leaves in the mean, or in the rate, of a window.
    double noise(double of_block, bool of_rate) const;

private:
    std::vector<double> time_;
    double step_ = 0;
    double samples_per_block_ = 1;
    std::size_t count_ = 0, length_ = 0;  // blocks in all, and in a window
};

}  // namespace tread::recording::checks
