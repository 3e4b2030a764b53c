// A pure time delay.
#pragma once

#include "tread/state_parts.h"

namespace tread {

// The signal moves from `begin` to `end` over dt; returns what it was `delay` (above 0) before that, exactly so for a
// signal that is linear between equal steps.
double advance(DelayLine& line, double begin, double end, double delay, double dt);

}  // namespace tread
