// The work of a campaign: computes the pieces that are missing, on several threads, beside other processes on the same
// folder.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "campaign/folder.h"
#include "campaign/run_one.h"

namespace tread::campaign {

// Part of the pieces: piece k is of part k modulo `of`.
struct Shard {
    std::uint64_t part = 0;
    std::uint64_t of = 1;

    bool has(std::uint64_t piece) const { return piece % of == part; }
};

struct Work {
    int threads = 0;  // 0: one per core
    Shard shard = {};
    std::function<bool()> stop = [] { return false; };
    // Runs done, by this process or others, of those that there are in this shard; called by one thread at a time.
    std::function<void(std::uint64_t done, std::uint64_t of)> progress = [](std::uint64_t, std::uint64_t) {};
    std::function<void(const std::string&)> warn = [](const std::string&) {};
};

struct Worked {
    std::uint64_t runs = 0;  // that this call has computed
    double seconds = 0;      // of all threads together, in these runs
    bool stopped = false;    // by `stop`; what was done is kept but for the pieces in work
    bool complete = false;   // all pieces of the campaign are there, not only those of the shard
};

// A damaged piece is reported and computed again. Returns when all pieces of the shard are there, those that other
// processes compute included. Throws FileError when a piece cannot be written.
Worked work(const Plan& plan, const Path& folder, const Measure& measure, const Work& options);

}  // namespace tread::campaign
