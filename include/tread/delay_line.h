// A pure time delay in trivially copyable state.
#pragma once

#include <array>
#include <cstddef>

namespace tread {

// A signal and its past: what it was some time ago, exactly so for a signal that is linear between equal steps.
class DelayLine {
public:
    // The signal moves from `begin` to `end` over dt; returns what it was `delay` (above 0) before that.
    double advance(double begin, double end, double delay, double dt);
    void fill(double value) { past_.fill(value); }

private:
    static constexpr std::size_t kIntervals = 200;  // of the delay: no longer than a millisecond for one of 0.2 s

    std::array<double, kIntervals + 1> past_{};  // at equal distances of time
    std::size_t newest_ = 0;
    double age_ = 0;  // s, since the newest
};

}  // namespace tread
