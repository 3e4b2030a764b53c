// A long work that is cut into pieces: several threads and processes on one folder compute each piece once, whoever of
// them dies, and a second call goes on where the first ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace tread {

// Part of the pieces: piece k is of part k modulo `of`.
struct Shard {
    std::uint64_t part = 0;
    std::uint64_t of = 1;

    bool has(std::uint64_t piece) const { return piece % of == part; }
};

// The pieces, numbered from 0. A piece has units, which are handed out to the threads one by one.
struct Pieces {
    std::uint64_t count = 0;
    std::function<std::uint64_t(std::uint64_t piece)> units = [](std::uint64_t) { return std::uint64_t{1}; };

    // Whether the result of a piece is on disk. `fault` says what is wrong with one that is there but damaged.
    std::function<bool(std::uint64_t piece, std::string& fault)> isDone;

    // Computes a unit, on any thread. False: it was interrupted, and the work ends.
    std::function<bool(std::uint64_t piece, std::uint64_t unit)> compute;

    // How a thread, to which so many units fall, does one after the other: calls computeNext() until it returns false,
    // also from within another call when that waits.
    std::function<void(std::uint64_t share, const std::function<bool()>& computeNext)> labour =
        [](std::uint64_t, const std::function<bool()>& computeNext) {
            while (computeNext()) {
            }
        };

    // After its last unit: writes the result of the piece.
    std::function<void(std::uint64_t piece)> finish = [](std::uint64_t) {};
};

struct WorkOptions {
    int threads = 0;  // 0: one per core
    Shard shard = {};
    std::function<bool()> stop = [] { return false; };
    // Units done, by this process or others, of those that there are in this shard; called by one thread at a time.
    std::function<void(std::uint64_t done, std::uint64_t of)> progress = [](std::uint64_t, std::uint64_t) {};
    std::function<void(const std::string&)> warn = [](const std::string&) {};
};

struct WorkDone {
    std::uint64_t units = 0;  // that this call has computed
    bool stopped = false;     // by `stop` or an interrupted unit; finished pieces are kept
};

// Returns when all pieces of the shard are done, those that other processes compute included. A damaged result is
// reported and computed again. `folder` holds the claims (claims.h). Throws what `compute` and `finish` throw.
WorkDone workTogether(const Pieces& pieces, const std::filesystem::path& folder, const WorkOptions& options);

}  // namespace tread
