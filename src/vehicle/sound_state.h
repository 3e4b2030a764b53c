// Whether a state that comes from outside can be stepped on with: what counts, chooses or points has to be among what
// there is, whatever bytes it was made of. Numbers that are no motion of a car break the step down, which says so.
#pragma once

#include "tread/vehicle.h"

namespace tread {

bool isSound(const VehicleState& state, const VehicleParams& params);

}  // namespace tread
