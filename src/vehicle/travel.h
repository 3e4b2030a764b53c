// Vertical motion of the wheels between road and body.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/wheel.h"

namespace tread {

const SuspensionParams& suspensionOf(const Vehicle& vehicle, std::size_t wheel);

// Force of spring, damper, bar and stops at one wheel.
SuspensionForce suspensionForce(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, std::size_t wheel);

// How the links guide the contact point: by the roll centre, and by the side-view slope for a wheel that rolls or whose
// brake is locked to the hub.
LinkSlopes linkSlopes(const Vehicle& vehicle, const WheelState& wheel, std::size_t index);

// Force that the links carry up onto the wheel from the horizontal tyre forces.
double linkForce(const Vehicle& vehicle, const WheelState& wheel, std::size_t index);

// Advances travel, rate and load of all wheels while the body moves from `begin` to `end`; returns the contacts at the
// end. `steer` is the angle of each wheel at the end, without toe.
PerWheel<WheelContact> advanceTravel(PerWheel<WheelState>& wheels, const Vehicle& vehicle, const BodyFrame& begin,
                                     const BodyFrame& end, const PerWheel<double>& steer, const Road& road, double dt);

}  // namespace tread
