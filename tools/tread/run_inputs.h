// What a run starts from: files and settings of the command line, resolved.
#pragma once

#include "commands.h"
#include "run/run_record.h"

namespace tread::program {

// A scenario file; also refuses what only the layers above can judge: a manoeuvre without metrics, channels that do not
// exist. Throws LoadError.
Scenario readScenario(const std::string& file);

// Throws LoadError: faults of the files and of the settings, a manoeuvre without metrics, channels that do not exist.
RunRecord readRunInputs(const RunOptions& options);

}  // namespace tread::program
