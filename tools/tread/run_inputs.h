// What a run starts from: files and settings of the command line, resolved.
#pragma once

#include "commands.h"
#include "run/run_record.h"

namespace tread::program {

// Throws LoadError: faults of the files, a manoeuvre that no metrics exist for, settings that do not fit.
RunRecord readRunInputs(const RunOptions& options);

}  // namespace tread::program
