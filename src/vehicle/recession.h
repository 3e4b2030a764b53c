// Longitudinal compliance of the suspension: a wheel moves forward and back against the body, on a spring and damper
// between both, with its own mass.
#pragma once

#include "tread/vehicle.h"
#include "vehicle/body.h"
#include "vehicle/wheel.h"

namespace tread {

// Each of these does nothing for a car whose wheels do not recede.

// Moves the wheels over the step under the road's forces at its beginning.
void advanceRecession(PerWheel<WheelState>& wheels, const Vehicle& vehicle, double dt);

// Adds the movement of a wheel to the motion of its tyre.
void recede(TyreMotion& motion, const Vehicle& vehicle, const Recession& recession, const WheelContact& contact);

// The wheels take the road's forces at the end of the step. Adds what the body feels besides these forces, which act on
// it as if the wheels were rigid along x: the wheels' own acceleration against it.
void addRecession(Wrench& wrench, PerWheel<WheelState>& wheels, const Vehicle& vehicle,
                  const PerWheel<WheelContact>& contacts, const BodyFrame& end, double dt);

}  // namespace tread
