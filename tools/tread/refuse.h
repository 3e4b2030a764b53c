// A fault of an option, a file or a folder as a whole.
#pragma once

#include <string>

#include "tread/problem.h"

namespace tread::program {

// Throws LoadError: `where` is the option or the name of the file.
[[noreturn]] inline void refuse(const std::string& where, const std::string& text) {
    throw LoadError({{where, 0, 0, "", text}});
}

}  // namespace tread::program
