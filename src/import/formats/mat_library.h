// The functions of matio that read MATLAB files. matio is loaded when the first such file is read, because the thirty
// libraries on which it depends (HDF5 and its network libraries) would nearly double the start-up time of every
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
