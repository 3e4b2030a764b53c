#include "tread/delay_line.h"

#include <algorithm>
#include <cmath>

namespace tread {

double DelayLine::advance(double begin, double end, double delay, double dt) {
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

}  // namespace tread
