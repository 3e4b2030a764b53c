// A log in memory, and what is known of the run that made it.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "drive.h"
#include "log/log.h"
#include "run/run_record.h"

namespace tread::python {

class LoggedRun {
public:
    std::string name;  // of the file, or the title of the scenario
    Log log;
    std::optional<RunRecord> record;    // none: the log was read from a file
    std::vector<std::string> warnings;  // numbers of the inputs that are hardly plausible

    // What the run answers, computed when it is first asked for: many runs are about their channels alone. Nothing for
    // a log without a record. From any thread.
    const program::Driven& driven() const {
        std::call_once(once_, [this] {
            if (record) driven_ = program::evaluate(*record, log);
        });
        return driven_;
    }

private:
    mutable std::once_flag once_;
    mutable program::Driven driven_;
};
using LoggedRunPointer = std::shared_ptr<LoggedRun>;  // pybind11 holds no pointers to const; nobody changes it

}  // namespace tread::python
