// Inputs and outputs of the car as arrays of numbers, by their described names.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tread/describe.h"
#include "tread/vehicle_output.h"

namespace tread::host {

struct Channel {
    std::string name;  // "chassis.yaw_rate"
    std::string unit;
    std::string meaning;  // "yaw angle, positive to the left"; of a wheel: with the wheel's name before it
    Limits limits;
    std::size_t offset;  // of the double in its struct
};

// In the order of the descriptions of VehicleInput and VehicleOutput.
const std::vector<Channel>& inputChannels();
const std::vector<Channel>& outputChannels();

// Index in one of these lists.
std::optional<std::size_t> indexOf(const std::vector<Channel>& channels, std::string_view name);

// Why a list has no channel of this name.
std::string unknownChannelText(const std::vector<Channel>& channels, std::string_view name);

template <class Struct>
double& valueOf(Struct& object, const Channel& channel) {
    return *reinterpret_cast<double*>(reinterpret_cast<char*>(&object) + channel.offset);
}
template <class Struct>
double valueOf(const Struct& object, const Channel& channel) {
    return *reinterpret_cast<const double*>(reinterpret_cast<const char*>(&object) + channel.offset);
}

// The input as pedals and hands can give it: what lies beyond a described limit is at that limit. Refuses what is no
// number.
VehicleInput withinLimits(VehicleInput input);

// The first output that is not finite, or nothing.
std::optional<std::size_t> firstNotFinite(const VehicleOutput& output);

}  // namespace tread::host
