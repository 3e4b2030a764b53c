// What the numbers of btRaycastVehicle mean for the car, and what a vehicle file puts in their place.
#pragma once

#include <array>
#include <cstring>
#include <optional>

#include "tread/bullet_precision.h"
#include "tread/raycast_vehicle.h"
#include "vehicle/wheeled_body.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// What a wheel of the car is made of, as it was when it was made: a change of any of these makes it anew.
struct WheelTuning {
    std::array<btScalar, 18> numbers{};
    // By its bits: what is not a number is equal to itself.
    bool operator==(const WheelTuning& other) const {
        return std::memcmp(numbers.data(), other.numbers.data(), sizeof numbers) == 0;
    }
};
WheelTuning tuningOf(const btWheelInfo& info);

// A wheel is steered no farther than this, either way.
inline constexpr double kMostSteer = 1e3;  // rad

// Load of each wheel at rest, as far as a tyre's size needs it.
double restingLoad(double mass, std::size_t wheels);

// A wheel from the stock numbers. None of them can make it other than finite: what is not a number, or out of all
// reason, is replaced by the nearest value that is.
BodyWheel wheelFromTuning(const btWheelInfo& info, double mass, double resting_load,
                          const std::optional<TyreParams>& tyre);

// A wheel with the tyre and suspension of a vehicle's axle; `left` says on which side of the car it is.
BodyWheel wheelFromFile(const btWheelInfo& info, const VehicleParams& params, bool left, double resting_load,
                        const std::optional<TyreParams>& tyre);

// The game's demand on a wheel that spins so fast. `from_file`: friction slip does not count.
WheelDemand demandOf(const btWheelInfo& info, const BodyWheel& wheel, double spin, bool from_file);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
