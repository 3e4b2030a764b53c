// The work of a campaign: computes the pieces that are missing, on several threads, beside other processes on the same
// folder.
#pragma once

#include <cstdint>

#include "campaign/folder.h"
#include "campaign/run_one.h"
#include "store/shared_work.h"

namespace tread::campaign {

struct Worked {
    std::uint64_t runs = 0;  // that this call has computed
    double seconds = 0;      // of all threads together, in these runs
    bool stopped = false;    // what was done is kept but for the pieces in work
    bool complete = false;   // all pieces of the campaign are there, not only those of the shard
};

// A damaged piece is reported and computed again. Returns when all pieces of the shard are there, those that other
// processes compute included. Throws FileError when a piece cannot be written.
Worked work(const Plan& plan, const Path& folder, const Measure& measure, const WorkOptions& options);

}  // namespace tread::campaign
