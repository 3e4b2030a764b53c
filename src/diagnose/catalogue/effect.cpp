#include "diagnose/catalogue/effect.h"

#include <algorithm>

#include "base/fields/numbers.h"
#include "recording/subject.h"

namespace tread::diagnose::catalogue {
namespace {

// The wanted value clamped to the limits. If it meets a limit that is itself excluded, half of the way from the nominal
// value to that limit.
double within(const Limits& limits, double wanted, double nominal) {
    const double value = std::clamp(wanted, limits.lowest, limits.highest);
    return limits.allow(value) ? value : 0.5 * (value + nominal);
}

}  // namespace

bool move(Subject& subject, const Knob& knob, double change) {
    const std::vector<Number> all = numbers(subject);
    bool moved = false;
    for (std::size_t i = 0; i < knob.paths.size(); ++i) {
        const auto number =
            std::find_if(all.begin(), all.end(), [&](const Number& n) { return n.path == knob.paths[i]; });
        if (number == all.end()) continue;
        const double part = change * knob.share(i);
        double& value = *number->value;
        value = within(number->about.limits, knob.relative ? value * (1 + part) : value + part, value);
        moved = true;
    }
    return moved;
}

bool applies(const Effect& effect, Subject subject) {
    return std::any_of(effect.knobs.begin(), effect.knobs.end(),
                       [&](const Knob& knob) { return move(subject, knob, 0); });
}

}  // namespace tread::diagnose::catalogue
