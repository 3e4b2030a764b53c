// A pure time delay in trivially copyable state.
#pragma once

#include <array>
#include <cstddef>

namespace tread {

// A signal and its past: what it was some time ago, exactly so for a signal that is linear between equal steps.
class DelayLine {
public:
    // The signal moves from `begin` to `end` over dt; returns what it was `delay` before that.
    double advance(double begin, double end, double delay, double dt) {
        if (delay <= 0) return end;
        const double interval = delay / kIntervals;
        constexpr double kRounding = 1e-9;  // a point that lies at the end of the step belongs to it
        const double points = std::floor((age_ + dt) / interval + kRounding);
        // Of more points than the line holds only the last matter.
        for (double i = std::max(points - (kIntervals + 1.0), 0.0) + 1; i <= points; ++i) {
            newest_ = (newest_ + 1) % past_.size();
            past_[newest_] = begin + (end - begin) * std::clamp((i * interval - age_) / dt, 0.0, 1.0);
        }
        age_ = std::max(age_ + dt - points * interval, 0.0);
        const double oldest = past_[(newest_ + 1) % past_.size()], next = past_[(newest_ + 2) % past_.size()];
        return oldest + (next - oldest) * std::min(age_ / interval, 1.0);
    }
    void fill(double value) { past_.fill(value); }

private:
    static constexpr std::size_t kIntervals = 200;  // of the delay: no longer than a millisecond

    std::array<double, kIntervals + 1> past_{};  // at equal distances of time
    std::size_t newest_ = 0;
    double age_ = 0;  // s, since the newest
};

}  // namespace tread
