// Natural frequencies of body and wheels: linear models of a quarter and of half a car about the standing car.
#pragma once

#include "sheet/at_rest.h"

namespace tread::sheet {

// NaN where there is no such mode.
struct Mode {
    double frequency;  // Hz, undamped: |eigenvalue| / 2 pi
    double damping;    // -, ratio
};

struct Ride {
    PerAxle<Mode> body;   // quarter car: sprung mass on an axle
    PerAxle<Mode> wheel;  // quarter car: wheel hop
    Mode heave;           // half car: body and both axles
    Mode pitch;
};

Ride ride(const AtRest& rest);

}  // namespace tread::sheet
