// A simulation judged against measurements: `tread compare --envelope`, `--score`.
#pragma once

#include <string>

#include "commands.h"
#include "compare/cross_plots.h"
#include "compare/score.h"
#include "compare/tolerances.h"

namespace tread::program {

// What `given` names: the standard, which has the default parameters, or a file. `option` is named in the fault. Throws
// LoadError.
CrossPlots crossPlotsOf(const std::string& given, const char* option = "--envelope");
ScoreParams scoreParamsOf(const std::string& given, const char* option = "--score");

// The defaults without a file. Throws LoadError, also for units that do not fit the channels of the reference.
Tolerances readTolerances(const std::string& file, const Log& reference);

int judge(const CompareOptions& options);

}  // namespace tread::program
