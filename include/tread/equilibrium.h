// Where a drive begins: the car in equilibrium at a place, a heading and a speed, so that nothing moves at t = 0 that
// the driver did not move.
#pragma once

#include "tread/api.h"
#include "tread/vehicle.h"

namespace tread {

struct Start {
    double x = 0;          // m, place on the road
    double y = 0;          // m
    double heading = 0;    // rad, about the vertical, 0 along x
    double speed = 0;      // m/s, forward
    VehicleInput input{};  // brake and clutch as they are held; the steering wheel too, where the car stands
};

struct Equilibrium {
    ChassisMotion motion;
    VehicleState state;
    VehicleInput input;   // with the throttle that holds the speed and the steering-wheel angle that holds the heading
    double throttle = 0;  // that this needs; outside 0 to 1 the car cannot hold the speed
    double acceleration = 0;  // m/s2, of the body that is left: not small when there is no equilibrium there
};

// A car that rolls is held at its speed and heading while it settles: throttle, steering wheel and sideslip are found
// that do so (on a bank, or with tyres that pull). A car that stands is left to its brakes.
TREAD_API Equilibrium equilibrium(const Vehicle& vehicle, const Surroundings& surroundings, const Start& start);

}  // namespace tread
