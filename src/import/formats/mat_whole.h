// Whether a MATLAB file is all there. matio does not notice a file that is cut off: it returns what happened to be in
// memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tread {

struct MatContents {
    // What is wrong, as one clause; empty when the variables of a version 4 or 5 file end where the file does, and hold
    // what they claim. Version 7.3 is HDF5, which checks itself.
    std::string fault;
    std::size_t variables = 0;  // of version 4 or 5
};

MatContents matContents(std::string_view bytes);

}  // namespace tread
