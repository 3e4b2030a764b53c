// The one result of a campaign: all pieces in the order of the runs, as a table and as a database. The bytes depend on
// the campaign alone, not on threads, shards or interruptions; what does depend on them, the durations, is in
// timings.csv.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "campaign/folder.h"
#include "campaign/row.h"

namespace tread::campaign {

struct Tally {
    std::uint64_t runs = 0;                 // in the result
    std::array<std::uint64_t, 5> of{};      // by status
    std::uint64_t missing = 0;              // runs whose piece is not there
    std::vector<std::string> damaged = {};  // pieces that were left out, with what is wrong
    double seconds = 0;                     // of all runs together

    std::uint64_t count(Status status) const { return of[static_cast<std::size_t>(status)]; }
    std::uint64_t failed() const { return runs - count(Status::ok) - count(Status::rejected); }
};

// Joins the pieces of several folders of one campaign and writes results.csv, results.sqlite and timings.csv into
// `target`. Writes nothing when a piece is missing or damaged, unless the result may be `partial`. Throws FileError.
Tally merge(const Plan& plan, const std::vector<Path>& folders, const Path& target, bool partial);

// What the pieces say, without a result being written.
Tally tally(const Plan& plan, const std::vector<Path>& folders);

// Bytes that a campaign will need: pieces, table and database, and logs as far as their size can be foreseen.
std::uint64_t bytesNeeded(const Plan& plan, std::uint64_t bytes_of_log);

}  // namespace tread::campaign
