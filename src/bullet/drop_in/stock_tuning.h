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
struct RestingLoad {
    double force;    // N
    double gravity;  // m/s2, under which it is that
    double mass() const { return force / gravity; }
};
// Without gravity, under that of the earth: somebody may pull the car down by other means.
RestingLoad restingLoad(double mass, std::size_t wheels, double gravity);

// A wheel from the stock numbers. None of them can make it other than finite: what is not a number, or out of all
// reason, is replaced by the nearest value that is.
BodyWheel wheelFromTuning(const btWheelInfo& info, double mass, const RestingLoad& resting,
                          const std::optional<TyreParams>& tyre);

// A wheel with the tyre and suspension of a vehicle's axle; `left` says on which side of the car it is.
BodyWheel wheelFromFile(const btWheelInfo& info, const VehicleParams& params, bool left, const RestingLoad& resting,
                        const std::optional<TyreParams>& tyre);

// How the engine's force at a wheel falls as the wheel spins. Slip speeds scale with the wheel's own_speed, as all
// speeds of cars of different size do:
//   a wheel's force fades as its rim runs six to eight of them ahead of the ground (a car's: 10 to 14 m/s);
//   one that is driven more than its partner at the other side, as of a skid-steered robot, loses 1.4 times the weight
//   on it for each of them, and all at five, in the proportion in which the partner is driven less: in full if it is
//   not driven, or the other way.
// The second is an electric motor's: the more force, the faster it turns the vehicle, but to a rate that stays.
DriveLimit driveLimit(const btWheelInfo& info, const btWheelInfo* partner, const BodyWheel& wheel);

// The game's demand on a wheel that spins so fast. `from_file`: friction slip does not count.
WheelDemand demandOf(const btWheelInfo& info, const BodyWheel& wheel, double spin, bool from_file);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
