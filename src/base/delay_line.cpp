#include "tread/delay_line.h"

#include <algorithm>
#include <cmath>

namespace tread {

double DelayLine::advance(double begin, double end, double delay, double dt) {
    const double interval = delay / kIntervals;
    constexpr double kRounding = 1e-9;  // a point that lies at the end of the step belongs to it
    const double points = std::floor((age_ + dt) / interval + kRounding);
    const auto after = [&](std::size_t i) { return i + 1 < past_.size() ? i + 1 : 0; };
    // Of more points than the line holds only the last matter.
    for (double i = std::max(points - (kIntervals + 1.0), 0.0) + 1; i <= points; ++i) {
        newest_ = after(newest_);
        past_[newest_] = begin + (end - begin) * std::clamp((i * interval - age_) / dt, 0.0, 1.0);
    }
    age_ = std::max(age_ + dt - points * interval, 0.0);
    const double oldest = past_[after(newest_)], next = past_[after(after(newest_))];
    return oldest + (next - oldest) * std::min(age_ / interval, 1.0);
}

}  // namespace tread
