// Unmeasured forces of an uneven road and moving air in World::assumed, as the diagnosis assumes them.
#pragma once

#include "base/math/random.h"
#include "run/push.h"

namespace tread::blind::world {

// Standard deviations of independent Ornstein-Uhlenbeck processes of mean 0 (model/disturbance of the diagnosis).
struct Disturbance {
    double fx = 30;                 // N
    double fy = 60;                 // N
    double yaw_moment = 20;         // N m
    double roll_moment = 40;        // N m
    double correlation_time = 0.7;  // s
};

// `step`: s, of the simulation. Deterministic in the seed.
Pushing wandering(const Disturbance& disturbance, double step, std::uint64_t seed);

}  // namespace tread::blind::world
