// The slip that most likely led to an implausible number: a unit that was left out or mistaken, a ratio upside down.
#pragma once

#include <string>
#include <string_view>

#include "tread/describe.h"

namespace tread {

// What was probably meant by a value as it was written ("550", "1250 lb"), where `unit` and plausible values are known:
// "\"550 mm\"", "1250 kg"; empty when no slip explains it.
std::string likelySlip(std::string_view written, std::string_view unit, const Usual& usual);

}  // namespace tread
