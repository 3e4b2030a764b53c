// Balance of the brakes against the ideal one, at which both axles use the same share of the grip.
#pragma once

#include "sheet/at_rest.h"

namespace tread::sheet {

// Brake force of an axle over its load at a position of the pedal, and the deceleration, both over gravity.
struct Braking {
    double deceleration;
    PerAxle<double> force;  // over the weight of the car
    PerAxle<double> use;    // force over the load that the axle then has
};
Braking brakingAt(const AtRest& rest, double pedal);

// Share of the brake force that the front axle has.
double frontShare(const AtRest& rest);                            // below the knee of a proportioning valve
double idealFrontShare(const AtRest& rest, double deceleration);  // deceleration over gravity

// Deceleration over gravity beyond which the rear axle is the first to use up its grip; NaN when it never is.
double rearLocksFirstAbove(const AtRest& rest);

}  // namespace tread::sheet
