// A scenario with all that it asks for: numbers tuned first, then one run or a series.
#pragma once

#include "drive.h"
#include "tread/problem.h"

namespace tread::program {

// Told how much of the first, or only, run is done, from 0 to 1; more when there are several.
using TellShare = std::function<void(double share)>;

// `implausible`: numbers of car and scenario that the message of a failed run of a series names. Throws
// SimulationError, SeriesError, FileError.
Driven driveScenario(const RunRecord& record, const Path& folder, const std::vector<Problem>& implausible,
                     const TellShare& tell);

}  // namespace tread::program
