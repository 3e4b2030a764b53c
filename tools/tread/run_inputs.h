// What a run starts from: files and settings of the command line, resolved.
#pragma once

#include <string>
#include <vector>

#include "commands.h"
#include "run/run_record.h"
#include "tread/problem.h"

namespace tread::program {

// A scenario file; also refuses what only the layers above can judge: a manoeuvre without metrics, channels that do not
// exist. Throws LoadError.
Scenario readScenario(const std::string& file);

// A car, and a scenario, as far as their files are sound; the faults are added to `problems`.
VehicleParams readVehicle(const std::string& file, std::vector<Problem>& problems);
Scenario readScenario(const std::string& file, std::vector<Problem>& problems);

// Car and scenario may have the bare names of shipped ones, "compact". Throws LoadError: faults of the files and of the
// settings, a manoeuvre without metrics, channels that do not exist. Implausible numbers are warned of, once in the
// whole program; with `strict` they are faults. They are returned for the message of a run that fails.
struct RunInputs {
    RunRecord record;
    std::vector<Problem> implausible = {};
};
RunInputs readRunInputs(const RunOptions& options);

}  // namespace tread::program
