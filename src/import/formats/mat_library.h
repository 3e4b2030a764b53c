// The functions of matio with which MATLAB files are read. matio is loaded with the first such file: the thirty
// libraries that it brings along (HDF5, and what HDF5 reads over networks) would take two thirds of the start of every
// program.
#pragma once

#include <matio.h>

#include <string>

namespace tread {

struct MatLibrary {
    decltype(&Mat_LogInitFunc) logInitFunc = nullptr;
    decltype(&Mat_Open) open = nullptr;
    decltype(&Mat_Close) close = nullptr;
    decltype(&Mat_VarReadNextInfo) varReadNextInfo = nullptr;
    decltype(&Mat_VarReadDataAll) varReadDataAll = nullptr;
    decltype(&Mat_VarFree) varFree = nullptr;
    decltype(&Mat_VarGetNumberOfFields) varGetNumberOfFields = nullptr;
    decltype(&Mat_VarGetStructFieldnames) varGetStructFieldnames = nullptr;
    decltype(&Mat_VarGetStructFieldByIndex) varGetStructFieldByIndex = nullptr;
};

// Throws a LoadError about `file` where matio cannot be loaded.
const MatLibrary& matLibrary(const std::string& file);

}  // namespace tread
