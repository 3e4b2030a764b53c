// First-order lag of a signal that is linear over each step: exact, whatever the step.
#pragma once

#include "base/math/elementary.h"

namespace tread {

// Where a value that follows a signal with a time constant gets to in a step: it starts at `from`, the signal goes from
// `begin` to `end` in `dt`.
[[gnu::always_inline]] inline double lagged(double from, double begin, double end, double time_constant, double dt) {
    if (time_constant == 0) return end;
    const double behind = time_constant * (end - begin) / dt;
    return end - behind + (from - begin + behind) * exponential(-dt / time_constant);
}

}  // namespace tread
