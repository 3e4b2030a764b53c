// The folder of a campaign's results: what it holds, and how several processes share it.
//
//     inputs.yaml     all inputs, resolved: the identity of the campaign
//     pieces/         runs that are done, a piece a file; a piece has its name only when it is complete and on disk
//     claims          which process computes which piece (store/claims.h)
//     results.csv, results.sqlite, report.html, timings.csv    once all pieces are there
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

Path inputsFile(const Path& folder);
Path pieceFile(const Path& folder, const Plan& plan, std::uint64_t piece);

// Makes the folder that of this campaign. Throws LoadError with the first difference when it is that of another,
// FileError when it cannot be written.
void openFolder(const Path& folder, const Plan& plan);

// The first lines that differ in two texts, in words; empty when they are equal.
std::string firstDifference(std::string_view before, std::string_view now);

// Which pieces have a file, damaged or not. Throws FileError.
std::vector<bool> piecesPresent(const Path& folder, const Plan& plan);

// Removes what killed processes have left in the folder under temporary names.
void removeAllLeftovers(const Path& folder);

}  // namespace tread::campaign
