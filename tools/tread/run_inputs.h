// What a run starts from: files and settings of the command line, resolved.
#pragma once

#include "commands.h"
#include "run/run_record.h"

namespace tread::program {

// Throws LoadError: faults of the files and of the settings, a manoeuvre without metrics, channels that do not exist.
RunRecord readRunInputs(const RunOptions& options);

}  // namespace tread::program
