#include "compare/tolerances.h"

#include <algorithm>

#include "base/text/number_text.h"
#include "base/text/pattern.h"
#include "base/units/units.h"

namespace tread {
namespace {

double inUnit(const Quantity& quantity, std::string_view unit) {
    std::string fault;
    return quantity.in(unit, fault).value_or(0);  // whoever reads the file has asked unitFaults()
}

// Metrics are in the units of the standards: 1e-4 rad is a least difference in deg, too.
double leastOf(const Tolerances& tolerances, std::string_view unit) {
    std::optional<double> converted;
    for (const UnitTolerance& known : tolerances.units) {
        const double absolute = inUnit(known.absolute, known.unit);
        if (known.unit == unit) return absolute;
        std::string fault;
        if (!converted) converted = toSi(numberText(absolute) + " " + known.unit, unit, fault);
    }
    return converted.value_or(0);
}

// "channels.1.absolute": the unit of a tolerance, against that of what it fits.
std::optional<ToleranceFault> wrongUnit(const std::optional<Quantity>& absolute, const std::string& path,
                                        std::string_view name, std::string_view unit) {
    std::string fault;
    if (!absolute || absolute->in(unit, fault)) return {};
    return ToleranceFault{path + ".absolute", fault + " (" + std::string(name) + ")"};
}

}  // namespace

AllowedDifference allowedDifference(const Tolerances& tolerances, const Channel& channel) {
    AllowedDifference allowed{0, tolerances.relative, false};
    for (const UnitTolerance& unit : tolerances.units) {
        if (unit.unit == channel.unit) allowed.absolute = inUnit(unit.absolute, unit.unit);
    }
    const ChannelTolerance* own = nullptr;
    for (const ChannelTolerance& candidate : tolerances.channels) {
        if (matches(candidate.channel, channel.name)) own = &candidate;
    }
    if (!own) return allowed;
    return {own->absolute ? inUnit(*own->absolute, channel.unit) : allowed.absolute,
            own->relative.value_or(allowed.relative), own->ignore};
}

AllowedDifference allowedDifference(const Tolerances& tolerances, std::string_view metric, std::string_view unit) {
    const double least = leastOf(tolerances, unit);
    AllowedDifference allowed{least, tolerances.relative, false};
    for (const MetricTolerance& own : tolerances.metrics) {
        if (!matches(own.metric, metric)) continue;
        allowed = {own.absolute ? inUnit(*own.absolute, unit) : least, own.relative.value_or(tolerances.relative),
                   own.ignore};
    }
    return allowed;
}

std::vector<ToleranceFault> unitFaults(const Tolerances& tolerances, const Log& reference) {
    std::vector<ToleranceFault> faults;
    for (const Channel& channel : reference.channels) {
        std::optional<ToleranceFault> fault;
        for (std::size_t i = 0; i < tolerances.channels.size(); ++i) {
            const ChannelTolerance& own = tolerances.channels[i];
            if (!matches(own.channel, channel.name)) continue;
            fault = wrongUnit(own.absolute, "channels." + std::to_string(i), channel.name, channel.unit);
        }
        const auto known = [&](const ToleranceFault& other) { return other.path == fault->path; };
        if (fault && std::none_of(faults.begin(), faults.end(), known)) faults.push_back(std::move(*fault));
    }
    return faults;
}

std::optional<ToleranceFault> unitFault(const Tolerances& tolerances, std::string_view metric, std::string_view unit) {
    std::optional<ToleranceFault> fault;
    for (std::size_t i = 0; i < tolerances.metrics.size(); ++i) {
        if (!matches(tolerances.metrics[i].metric, metric)) continue;
        fault = wrongUnit(tolerances.metrics[i].absolute, "metrics." + std::to_string(i), metric, unit);
    }
    return fault;
}

}  // namespace tread
