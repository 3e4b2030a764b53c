#include "compare/tolerances.h"

#include "base/pattern.h"

namespace tread {

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
