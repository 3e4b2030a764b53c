// The constant delay between two recordings of the same thing.
#pragma once

#include <optional>

#include "log/log.h"

namespace tread {

// By how many seconds `candidate` is later than `reference`, within +-`largest`: where the correlation of the two
// channels has its peak. Nothing when it has none: a constant or non-finite channel, too little common time, or a peak
// at the limit.
std::optional<double> estimateTimeShift(const Log& reference, const Log& candidate, std::string_view channel,
                                        double largest);

}  // namespace tread
