// A pure time delay in trivially copyable state.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tread {

// Keeps the last samples of a signal. Exact for steps of constant length that divide the delay; a delay of more than
// kSamples - 2 steps is sampled more coarsely, and what lies between two samples is interpolated.
class DelayLine {
public:
    // Value of the signal `delay` before the end of a step of length dt at whose end it is `input`.
    double advance(double input, double delay, double dt) {
        if (delay <= 0) return input;
        const double spacing = std::max(dt, delay / static_cast<double>(kSamples - 2));
        since_ += dt;
        if (since_ > spacing * (1 - kRounding)) {
            newest_ = (newest_ + 1) % kSamples;
            samples_[newest_] = input;
            since_ = std::max(since_ - spacing, 0.0);
            if (since_ < kRounding * spacing) since_ = 0;
        }
        const double back = (delay - since_) / spacing;
        if (back <= 0) return input + (samples_[newest_] - input) * (since_ > 0 ? delay / since_ : 0);
        const double whole = std::floor(back + kRounding);
        const double rest = std::max(back - whole, 0.0);
        const auto steps = static_cast<std::size_t>(whole);
        const double later = samples_[(newest_ + kSamples - steps) % kSamples];
        const double earlier = samples_[(newest_ + 2 * kSamples - steps - 1) % kSamples];
        return later + rest * (earlier - later);
    }

private:
    static constexpr std::size_t kSamples = 128;
    static constexpr double kRounding = 1e-9;

    std::array<double, kSamples> samples_{};
    std::size_t newest_ = 0;
    double since_ = 0;  // s, since the newest sample
};

}  // namespace tread
