// Whether the elements of a version 5 variable are as many as its arrays claim. matio takes memory for what a cell
// array or a struct claims before it looks for it: 150 bytes can ask for gigabytes.
#pragma once

#include <string>
#include <string_view>

namespace tread {

// What is wrong within the content of a matrix element, as a clause; empty when nothing is.
std::string matrixFault(std::string_view content, bool big_endian);

// The same for the content of a compressed element.
std::string compressedFault(std::string_view content, bool big_endian);

}  // namespace tread
