// The overlay report of a comparison.
#pragma once

#include "compare/compare.h"
#include "log/log.h"
#include "report/overlay_report.h"

namespace tread::program {

// The curves, on the samples of the reference within the common time; the constant delay that the comparison found is
// taken out. `others` are drawn as they are.
std::vector<ChannelOverlay> overlays(const Log& reference, const Log& candidate, const std::vector<Log>& others,
                                     const Comparison& comparison);

}  // namespace tread::program
