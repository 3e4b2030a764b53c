// What a drawing of the car needs. Wheels, wheelbase and tracks are the car's own; the body around them is a guess.
#pragma once

#include "scenario/course.h"
#include "tread/vehicle.h"

namespace tread {

struct CarShape {
    PerWheel<Vector3> hubs;         // m, wheel centres at static load against the centre of gravity, ISO 8855
    PerWheel<double> wheel_radius;  // m, unloaded
    double height = 0;              // m, of the centre of gravity above the road
    double ahead = 0;               // m, from the centre of gravity to the front end
    double behind = 0;              // m, to the rear end
    double width = 0;               // m
    double roof = 0;                // m, above the road

    double length() const { return ahead + behind; }
};

// `outline`: of the body, where a course says it; width 0: guessed.
CarShape carShape(const VehicleParams& vehicle, const CarOutline& outline = {});

// For a log of which the car is not known: a medium one.
CarShape typicalCarShape();

}  // namespace tread
