// What pushes a car besides its tyres, the air and gravity: uneven roads, gusts, what a model does not know.
#pragma once

#include <functional>

#include "tread/vector.h"
#include "tread/vehicle_output.h"

namespace tread {

// At the centre of gravity; axes level, x along the heading, y to the left, z up.
struct Push {
    Vector3 force = Vector3::Zero();   // N
    Vector3 moment = Vector3::Zero();  // N m
};

// Push over the coming step of the world, asked once for each.
using Pushing = std::function<Push(double time, const VehicleInput& driver, const VehicleOutput& car)>;

// One that depends on the time alone: nothing of the car has to be looked at for it.
struct PushingOverTime {
    std::function<Push(double time)> at;
    Push operator()(double time, const VehicleInput&, const VehicleOutput&) const { return at(time); }
};

}  // namespace tread
