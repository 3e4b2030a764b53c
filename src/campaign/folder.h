// The folder of a campaign's results: what it holds, and how several processes share it.
//
//     inputs.yaml     all inputs, resolved: the identity of the campaign
//     pieces/         runs that are done, a piece a file; a piece has its name only when it is complete and on disk
//     claims          byte k is locked by whoever computes piece k; the operating system frees it when that process
//     dies results.csv, results.sqlite, report.html, timings.csv    once all pieces are there
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/plan.h"

namespace tread::campaign {

using Path = std::filesystem::path;

// Writes a file beside its place under a name that nobody else uses, makes sure that it is on disk, and gives it its
// name in one step. Throws FileError.
void writeDurably(const Path& file, std::string_view text);

// A process's hold on pieces.
class Claims {
public:
    explicit Claims(const Path& folder);  // throws FileError
    ~Claims();
    Claims(const Claims&) = delete;
    Claims& operator=(const Claims&) = delete;

    // False when another process computes the piece. True on a file system without locks: then two may compute the same
    // piece, with the same result.
    bool take(std::uint64_t piece);
    void release(std::uint64_t piece);

private:
    int file_ = -1;
};

// Pieces that some process computes at this moment; none when nobody has begun.
std::vector<std::uint64_t> claimed(const Path& folder, std::uint64_t pieces);

Path inputsFile(const Path& folder);
Path pieceFile(const Path& folder, const Plan& plan, std::uint64_t piece);

// Makes the folder that of this campaign. Throws LoadError with the first difference when it is that of another,
// FileError when it cannot be written.
void openFolder(const Path& folder, const Plan& plan);

// The first lines that differ in two texts, in words; empty when they are equal.
std::string firstDifference(std::string_view before, std::string_view now);

// Which pieces have a file, damaged or not.
std::vector<bool> piecesPresent(const Path& folder, const Plan& plan);

// Removes what killed processes have left under temporary names.
void removeLeftovers(const Path& folder);

}  // namespace tread::campaign
