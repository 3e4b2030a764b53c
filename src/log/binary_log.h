// A log as compact columns. The file is a Zstandard frame (RFC 8878); inside:
//
//     tread log 1
//     rows <number of rows>
//     <one line for each column: name [unit]>
//     <an empty line>
//     the columns one after the other, each as that many doubles (IEEE 754 binary64, little-endian)
#pragma once

#include <string>
#include <string_view>

#include "log/log.h"

namespace tread {

std::string binaryLog(const Log& log);

// Whether the bytes begin like such a file.
bool isBinaryLog(std::string_view bytes);

// Throws LoadError that names `file` when the bytes are no whole log.
Log parseBinaryLog(std::string_view bytes, const std::string& file);

}  // namespace tread
