// Text for a terminal in lines that fit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tread::program {

// Columns of the terminal that standard output goes to; 100 where it goes elsewhere.
std::size_t outputColumns();

// The words in lines of at most `columns`, the first one without its indent, which stands already, the others behind
// `indent` spaces. A word that is longer than a line has a line of its own.
std::string wrapped(std::string_view words, std::size_t indent, std::size_t columns);

}  // namespace tread::program
