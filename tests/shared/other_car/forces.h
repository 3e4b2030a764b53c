// Forces and accelerations of the other car at one instant. ISO 8855 axes of the car; wheels front left, front right,
// rear left, rear right.
#pragma once

#include <array>

#include "shared/other_car/state.h"

namespace other_car {

struct Forces {
    std::array<double, 4> fx, fy, load;  // N, in wheel axes
    double ax = 0, ay = 0;               // m/s2, acceleration of the centre of gravity
    double felt_ax = 0,
           felt_ay = 0;  // m/s2, specific force: ax, ay plus gravity along a sloping road; it leans the body
    Vector rate{};       // of the states, per second
};

// External forces and moments at the centre of gravity.
struct Push {
    double fx = 0, fy = 0, roll = 0, pitch = 0, yaw = 0;  // N, N m
};

// Force and yaw moment in the plane of the road.
struct PlaneForce {
    double x, y, moment;  // N, N, N m
};

}  // namespace other_car
