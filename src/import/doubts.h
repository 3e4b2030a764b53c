// Whether the channels of an imported log fit one another.
#pragma once

#include <vector>

#include "import/import.h"

namespace tread {

// Values that no road vehicle reaches; signs, units and places of channels that the physics of a rolling rigid body
// contradicts, and by the majority of the relations the channel that is the odd one out.
std::vector<Change> doubts(const Log& log);

}  // namespace tread
