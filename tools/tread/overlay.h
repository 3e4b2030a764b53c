// The overlay report of a comparison.
#pragma once

#include <string>
#include <vector>

#include "compare/compare.h"
#include "log/log.h"
#include "report/overlay_report.h"
#include "run/run_record.h"

namespace tread::program {

// The curves, on the samples of the reference within the common time; the constant delay that the comparison found is
// taken out. `others` are drawn as they are.
std::vector<ChannelOverlay> overlays(const Log& reference, const Log& candidate, const std::vector<const Log*>& others,
                                     const Comparison& comparison);

// A log on the page: its name, its file (empty: in memory), and its inputs as far as they are known.
struct ComparedLog {
    std::string name, file;
    const Log& log;
    const RunRecord* record = nullptr;
};

// The page of a comparison of the second log with the first; the others are drawn beside them.
std::string comparisonReport(const std::vector<ComparedLog>& logs, const Comparison& comparison,
                             const std::string& answer);

}  // namespace tread::program
