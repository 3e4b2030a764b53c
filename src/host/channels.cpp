#include "host/channels.h"

#include <algorithm>
#include <cmath>

#include "base/fields/numbers.h"
#include "base/text/concat.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "host/failure.h"

namespace tread::host {
namespace {

// "front left wheel: normal load of the tyre"
std::string meaningWithin(std::string_view path, std::string_view meaning) {
    constexpr std::string_view kWheel = "wheel.";
    if (!path.starts_with(kWheel)) return std::string(meaning);
    path.remove_prefix(kWheel.size());
    std::string_view wheel;
    PerWheel<double> names;
    PerWheel<double>::describe(names, [&](std::string_view name, const double&, const About& about) {
        if (path.starts_with(concat({name, "."}))) wheel = about.meaning;
    });
    return concat({wheel, ": ", meaning});
}

template <class Struct>
std::vector<Channel> channelsOf() {
    Struct object;
    std::vector<Channel> channels;
    for (const Number& n : numbers(object)) {
        const auto offset = reinterpret_cast<char*>(n.value) - reinterpret_cast<char*>(&object);
        channels.push_back({n.path, std::string(n.about.unit), meaningWithin(n.path, n.about.meaning), n.about.limits,
                            static_cast<std::size_t>(offset)});
    }
    return channels;
}

}  // namespace

const std::vector<Channel>& inputChannels() {
    static const std::vector<Channel> channels = channelsOf<VehicleInput>();
    return channels;
}

const std::vector<Channel>& outputChannels() {
    static const std::vector<Channel> channels = channelsOf<VehicleOutput>();
    return channels;
}

std::optional<std::size_t> indexOf(const std::vector<Channel>& channels, std::string_view name) {
    const auto found = std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == name; });
    if (found == channels.end()) return {};
    return static_cast<std::size_t>(found - channels.begin());
}

std::string unknownChannelText(const std::vector<Channel>& channels, std::string_view name) {
    std::vector<std::string_view> names;
    for (const Channel& channel : channels) names.push_back(channel.name);
    const auto near = closest(name, names);
    const std::string text = concat({"found the unknown name ", quote(name), ", expected that of a channel"});
    return near ? concat({text, "; did you mean ", quote(*near), "?"}) : text;
}

VehicleInput withinLimits(VehicleInput input) {
    for (const Channel& channel : inputChannels()) {
        double& value = valueOf(input, channel);
        if (!std::isfinite(value))
            refuse(concat({"input ", channel.name, ": found ", std::isnan(value) ? "NaN" : "infinity",
                           ", expected a finite number"}));
        value = std::clamp(value, channel.limits.lowest, channel.limits.highest);
    }
    return input;
}

std::optional<std::size_t> firstNotFinite(const VehicleOutput& output) {
    const std::vector<Channel>& channels = outputChannels();
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const Channel& channel) { return !std::isfinite(valueOf(output, channel)); });
    if (found == channels.end()) return {};
    return static_cast<std::size_t>(found - channels.begin());
}

}  // namespace tread::host
