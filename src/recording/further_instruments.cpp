#include "recording/further_instruments.h"

#include <algorithm>

#include "base/text/number_text.h"
#include "log/log_columns.h"
#include "recording/observation.h"

namespace tread::recording {
namespace {

constexpr std::string_view kFurther = "instruments.further.", kMountings = "instruments.mountings.";

// "ax" for the instrument &Instruments::ax.
std::string nameOf(Instrument Instruments::*instrument) {
    Instruments all;
    std::string name;
    Instruments::describe(all, [&](std::string_view field, auto& value, const About&) {
        if (static_cast<const void*>(&value) == &(all.*instrument)) name = field;
    });
    return name;
}

// A word behind @ has no dots, so the name of the number is what follows the last one.
struct FurtherPath {
    std::string_view of;      // channel or source
    std::string_view number;  // "delay"
};
FurtherPath split(std::string_view path, std::string_view beginning) {
    path.remove_prefix(beginning.size());
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos ? FurtherPath{path, {}}
                                         : FurtherPath{path.substr(0, dot), path.substr(dot + 1)};
}

// Channels that a mounting moves or turns.
bool isMounted(std::string_view channel) {
    const std::string_view quantity = quantityOf(channel);
    return quantity == "chassis.ax" || quantity == "chassis.ay" || quantity == "chassis.vx" || quantity == "chassis.vy";
}

void addInstrument(Instruments& instruments, const std::string& channel) {
    const auto is = [&](const FurtherInstrument& one) { return one.channel == channel; };
    if (std::none_of(instruments.further.begin(), instruments.further.end(), is))
        instruments.further.push_back({channel, {}});
    if (!isMounted(channel)) return;
    const auto of = [&](const Mounting& one) { return one.source == sourceOf(channel); };
    if (std::none_of(instruments.mountings.begin(), instruments.mountings.end(), of))
        instruments.mountings.push_back({std::string(sourceOf(channel)), {}});
}

}  // namespace

void addFurtherInstruments(Instruments& instruments, const std::vector<Log>& logs) {
    for (const Log& log : logs) {
        for (const Channel& channel : log.channels) {
            if (!sourceOf(channel.name).empty() && observedQuantity(channel.name))
                addInstrument(instruments, channel.name);
        }
    }
}

std::string pathInFirst(std::string_view path) {
    if (path.starts_with(kMountings)) return "instruments.inertial_unit." + std::string(split(path, kMountings).number);
    if (!path.starts_with(kFurther)) return {};
    const FurtherPath further = split(path, kFurther);
    const ObservedQuantity* quantity = observedQuantity(further.of);
    if (!quantity) return {};
    return "instruments." + nameOf(quantity->instrument) + "." + std::string(further.number);
}

std::string_view sourceOfPath(std::string_view path) {
    if (path.starts_with(kMountings)) return split(path, kMountings).of;
    return path.starts_with(kFurther) ? sourceOf(split(path, kFurther).of) : std::string_view();
}

std::string furtherChannelFault(const std::string& channel) {
    const std::string_view source = sourceOf(channel);
    const bool word = !source.empty() && source.find_first_of(".@ ") == std::string_view::npos;
    if (word && observedQuantity(channel)) return {};
    return "found " + quote(channel) +
           ", expected a channel with its source after @, such as chassis.yaw_rate@can; the quantity is one of " +
           observedQuantitiesListed();
}

}  // namespace tread::recording
