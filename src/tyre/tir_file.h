// Import of .tir tyre property files of the Magic Formula versions 5.0 to 5.2 and PAC2002 (ISO axes) into the paper's
// parameters and axes (y right, z down).
//
// Both models share the paper's appendix except for a handful of terms; what a file says beyond it is dropped and named
// in a warning with its value. What the transient part of the paper needs and a file lacks is derived or guessed, and
// named too. Files that take alpha as an angle are read as if it were the tangent (below 0.25 rad this costs 1.1 % of
// Fz).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tread/tyre.h"

namespace tread {

// Throws LoadError with all faults of the file: bad lines, units, numbers, missing keys, or another tyre model.
TyreParams readTir(const std::filesystem::path& file, std::vector<std::string>& warnings);

// The same from the text of a file; `file` is its name in messages.
TyreParams parseTir(std::string_view written, const std::string& file, std::vector<std::string>& warnings);

}  // namespace tread
