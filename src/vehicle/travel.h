// Vertical motion of the wheels between road and body.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/wheel.h"

namespace tread {

const SuspensionParams& suspensionOf(const Vehicle& vehicle, std::size_t wheel);

// Advances travel, rate and load of all wheels while the body moves from `begin` to `end`; returns the contacts at the
// end. `steer` is the angle of each wheel at the end, without toe.
PerWheel<WheelContact> advanceTravel(PerWheel<WheelState>& wheels, const Vehicle& vehicle, const BodyFrame& begin,
                                     const BodyFrame& end, const PerWheel<double>& steer, const Road& road, double dt);

// How the contact of a wheel moves in the body over its travel. A wheel that its brake locks turns with its carrier.
Vector3 contactSlopes(const WheelState& wheel, const Vehicle& vehicle, std::size_t index);

// Keeps the tyre forces at the end of the step, and what they push along the wheel's travel: their own share along the
// body's z axis, and the links (roll centre, side-view slopes). The wheel moved under those of the step's beginning and
// takes the change.
void takeTyreForces(WheelState& wheel, const TyreForces& tyre, const Vehicle& vehicle, const WheelContact& contact,
                    std::size_t index, double dt);

}  // namespace tread
