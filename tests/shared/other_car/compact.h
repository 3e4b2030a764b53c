// The compact hatchback of the vehicles, roughly, as a car of the other simulator.
#pragma once

#include "shared/other_car/car.h"

namespace other_car {

inline Params compact() {
    Params p;
    p.front.tyre.stiffness = p.rear.tyre.stiffness = 55000;
    p.front.track = 1.53;
    p.front.roll_stiffness = 60900;
    p.front.roll_damping = 1960;
    p.front.roll_axis = 0.06;
    p.front.wheel_inertia = 1.0 + 0.5 * 0.148 * p.drive_ratio * p.drive_ratio;  // with half of the engine
    p.front.compliance_steer = -2.5e-6;
    p.rear.track = 1.51;
    p.rear.roll_stiffness = 41000;
    p.rear.roll_damping = 1510;
    p.rear.roll_axis = 0.11;
    p.rear.wheel_inertia = 0.95;
    return p;
}

}  // namespace other_car
