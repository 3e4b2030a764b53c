// Units as other programs spell them: "kmh", "degs", "mps2", "NewtonMet", "%".
#pragma once

#include <string>
#include <string_view>

namespace tread {

// The same unit as tread spells it ("km/h", "deg/s"); empty when it is none that tread knows.
std::string spelledUnit(std::string_view foreign);

// The unit that a name carries at its end, "yaw_rate_degs", "velocity kmh", as tread spells it; empty when it has none.
std::string unitInName(std::string_view name);

// The name without it.
std::string_view nameWithoutUnit(std::string_view name);

// The SI unit, as the channels of a log bear it, of what a unit (in tread's spelling) measures: "rad/s" for "rpm". The
// unit itself when tread has no name for its SI unit.
std::string siUnitOf(std::string_view unit);

}  // namespace tread
