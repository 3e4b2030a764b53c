// All that a car remembers: a copy to go back to, or bytes to keep.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "host/body.h"
#include "tread/vehicle.h"

namespace tread::host {

struct Snapshot {
    ChassisMotion motion;
    VehicleState state;
    VehicleInput input;       // at the time of the last step
    VehicleInput next;        // as given since
    bool ramps = false;       // the next step begins with `input`, not with `next`
    double time = 0;          // s
    double time_rest = 0;     // s, lost of it by rounding
    double carried = 0;       // s, by which the host is ahead
    double yaw = 0;           // rad, counted on over whole turns
    Vector3 wind_W{0, 0, 0};  // m/s
    std::array<RoadContact, kWheels> planes{};
    BodyLink link;
};

// The bytes of a snapshot. They say which layout they have and for which car they are.
std::vector<std::byte> bytesOf(const Snapshot& snapshot, std::uint64_t car);

// Bytes that bytesOf() gives, always the same number.
std::size_t snapshotSize();

// Back again; refuses what another version of tread wrote, what belongs to another car, and what is damaged.
Snapshot snapshotOf(std::span<const std::byte> bytes, std::uint64_t car);

// FNV-1a, 64 bits.
std::uint64_t hashOf(std::span<const std::byte> bytes, std::uint64_t basis = 14695981039346656037u);

}  // namespace tread::host
