// What a proving ground does to a car that no log tells: the road is not even and the air is not still.
#pragma once

#include "base/random.h"
#include "run/push.h"

namespace tread {

// Standard deviations of the forces and moments that wander about zero (Ornstein-Uhlenbeck processes).
struct Disturbance {
    double fx = 30;                 // N
    double fy = 60;                 // N
    double yaw_moment = 80;         // N m
    double roll_moment = 40;        // N m
    double correlation_time = 0.7;  // s
};

// `step`: s, of the world. The same seed gives the same pushes.
Pushing wandering(const Disturbance& disturbance, double step, std::uint64_t seed);

}  // namespace tread
