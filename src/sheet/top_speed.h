// Full throttle on a level road: where the driving force meets drag and rolling resistance.
#pragma once

#include <vector>

#include "sheet/at_rest.h"

namespace tread::sheet {

enum class SpeedLimit {
    power,    // resistance takes all that engine and motor give
    gearing,  // engine or motor is at its speed limit
    shift     // the gearbox shifts up, and the next gear cannot hold the speed
};

struct TopSpeed {
    double speed;  // m/s; NaN when the car does not drive
    int gear;
    SpeedLimit limit;
    double power;  // W, that drag and rolling resistance take there
};
TopSpeed topSpeed(const AtRest& rest);

// Power of drag and rolling resistance at a speed, W.
double resistancePower(const AtRest& rest, double speed);

}  // namespace tread::sheet
