// A log in memory, and what is known of the run that made it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drive.h"
#include "log/log.h"
#include "run/run_record.h"

namespace tread::python {

struct LoggedRun {
    std::string name;  // of the file, or the title of the scenario
    Log log;
    std::optional<RunRecord> record;  // none: the log was read from a file
    program::Driven driven;           // of a run
    std::vector<std::string> warnings;
};
using LoggedRunPointer = std::shared_ptr<LoggedRun>;  // pybind11 holds no pointers to const; nobody changes it

}  // namespace tread::python
