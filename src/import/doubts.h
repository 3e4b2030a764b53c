// Whether the channels of an imported log fit one another.
#pragma once

#include <vector>

#include "import/import.h"

namespace tread {

// Signs and units that the physics of a car contradicts: lateral acceleration against vx times yaw rate, steering wheel
// against yaw rate, wheel speeds against vx.
std::vector<Change> doubts(const Log& log);

}  // namespace tread
