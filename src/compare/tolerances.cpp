#include "compare/tolerances.h"

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

AllowedDifference allowedDifference(const Tolerances& tolerances, const Channel& channel) {
    AllowedDifference allowed{0, tolerances.relative, false};
    for (const UnitTolerance& unit : tolerances.units) {
        if (unit.unit == channel.unit) allowed.absolute = unit.absolute;
    }
    const ChannelTolerance* own = nullptr;
    for (const ChannelTolerance& candidate : tolerances.channels) {
        if (matches(candidate.channel, channel.name)) own = &candidate;
    }
    if (!own) return allowed;
    return {own->absolute.value_or(allowed.absolute), own->relative.value_or(allowed.relative), own->ignore};
}

}  // namespace tread
