// Whether a car can start from the equilibrium that was found for it.
#pragma once

#include "tread/equilibrium.h"

namespace tread::host {

enum class StartFault {
    none,
    broke_down,      // its acceleration is not finite
    no_equilibrium,  // it still accelerates after settling
    too_fast         // no throttle from 0 to 1 holds the speed
};

// `needs_throttle`: the driver must be able to hold the speed with the pedal.
StartFault startFault(const Equilibrium& rest, double speed, bool needs_throttle = true);

}  // namespace tread::host
