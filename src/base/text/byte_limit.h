// Limits in bytes that a variable of the environment may change.
#pragma once

#include <cstddef>

namespace tread {

// What the variable says, as a whole number; `usual` when it is not set. Throws LoadError that names the variable when
// it says something else.
std::size_t byteLimit(const char* variable, std::size_t usual);

}  // namespace tread
