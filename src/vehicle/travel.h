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

// The force that the links carry up onto the wheel, from the tyre forces at the end of the step: roll centre (lateral
// force) and side-view slopes (longitudinal force). The wheel takes the change against what it moved under.
void correctLinks(WheelState& wheel, const Vehicle& vehicle, std::size_t index, double dt);

}  // namespace tread
