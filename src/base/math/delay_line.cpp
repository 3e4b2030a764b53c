#include "base/math/delay_line.h"

#include <algorithm>
#include <cmath>

namespace tread {

double advance(DelayLine& line, double begin, double end, double delay, double dt) {
    auto& past = line.past;
    const double interval = delay / DelayLine::kIntervals;
    constexpr double kRounding = 1e-9;  // a point that lies at the end of the step belongs to it
    constexpr double kMost = 1e12;      // points of a step, whose numbers and places are still told apart
    const double points = std::floor((line.age + dt) / interval + kRounding);
    if (!(points < kMost)) {
        past.fill(end);
        line.age = 0;
        return end;  // no delay
    }
    const auto after = [&](std::size_t i) { return i + 1 < past.size() ? i + 1 : 0; };
    // Of more points than the line holds only the last matter.
    for (double i = std::max(points - (DelayLine::kIntervals + 1.0), 0.0) + 1; i <= points; ++i) {
        line.newest = after(line.newest);
        past[line.newest] = begin + (end - begin) * std::clamp((i * interval - line.age) / dt, 0.0, 1.0);
    }
    line.age = std::max(line.age + dt - points * interval, 0.0);
    const double oldest = past[after(line.newest)], next = past[after(after(line.newest))];
    return oldest + (next - oldest) * std::min(line.age / interval, 1.0);
}

}  // namespace tread
