// The log of a run.
#pragma once

#include "campaign/plan.h"
#include "log/binary_log.h"

namespace tread::campaign {

inline std::filesystem::path logFile(const std::filesystem::path& folder, RunNumber run) {
    std::string number = std::to_string(run);
    if (number.size() < 9) number.insert(0, 9 - number.size(), '0');
    return folder / "logs" / (number + ".tlog");
}

}  // namespace tread::campaign
