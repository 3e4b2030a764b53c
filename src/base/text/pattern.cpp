#include "base/text/pattern.h"

#include <cstddef>

namespace tread {

bool matches(std::string_view pattern, std::string_view name) {
    std::size_t p = 0, n = 0;
    // On a mismatch the last star takes one character more.
    std::size_t star = std::string_view::npos, behind_star = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            behind_star = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++behind_star;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace tread
