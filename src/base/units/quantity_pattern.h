// What a quantity in a file may look like, as a regular expression (ECMA 262) for editors.
#pragma once

#include <string>
#include <string_view>

#include "tread/describe.h"

namespace tread {

// Fits every text that the reader takes for a number within the limits, in `unit` or with a unit of the same kind
// (except "-0" where no negative number is allowed). It does not fit most of what the reader refuses: a unit by name
// that measures something else or that nobody knows, a negative number where there must be none. Products and quotients
// of units are beyond regular expressions and all fit.
std::string quantityPattern(std::string_view unit, const Limits& limits);

}  // namespace tread
