// Pieces of text, one after the other. (Chains of `+` that begin with a literal make g++ 12 warn of overlaps that are
// not there.)
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace tread {

inline std::string concat(std::initializer_list<std::string_view> pieces) {
    std::string text;
    for (const std::string_view piece : pieces) text += piece;
    return text;
}

}  // namespace tread
