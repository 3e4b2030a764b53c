// What a described number can be at all. Plausible values (tread/describe.h) only warn; a number whose size is more
// than a factor of 1000 beyond them describes no car: an engine without inertia, a steering without ratio.
#pragma once

#include <string>
#include <string_view>

#include "tread/describe.h"

namespace tread {

// 0 and infinity are no sizes: the limits of the description say whether they are allowed.
bool isPossible(const Usual& usual, double value);

// "found "1e-308", expected a number in kg m2 between 1e-06 and 5000 in size, ...; did you mean ...?" `written` is how
// a file or an option says it; empty when that is not known.
std::string impossibleText(double value, std::string_view written, std::string_view unit, const Usual& usual);

// The limits of the description, narrowed to what is possible as far as limits can say it.
Limits possibleLimits(const About& about);

}  // namespace tread
