// Replays of logs as signals over time.
#pragma once

#include <filesystem>

#include "scenario/scenario.h"

namespace tread {

// Makes the files that replays name relative to the folder of the scenario.
void placeReplays(Scenario& scenario, const std::filesystem::path& folder);

// The scenario with the logged values in place of the replays of them, and of what it takes from its drive: speed, time
// of the end, a run-in when that begins in a turn. Throws LoadError with every fault, FileError when a log cannot be
// read.
Scenario withReplaysRead(Scenario scenario);

}  // namespace tread
