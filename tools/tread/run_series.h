// A scenario that asks for several runs: each into a folder of its own, and one table over them.
#pragma once

#include "drive.h"
#include "tread/problem.h"

namespace tread::program {

// The record with the numbers found that its scenario wants tuned.
RunRecord tunedRecord(RunRecord record, const Stop& stop = stopAsked);

// Drives the series of a scenario into `folder`, its runs into folders 01, 02, ... there. A run that fails is part of
// the result; its message names the `implausible` numbers of car and scenario.
Driven driveSeries(const RunRecord& record, const Path& folder, const std::vector<Problem>& implausible,
                   const Tell& tell);

}  // namespace tread::program
