// What the surroundings of the tyres make of their step: ply-steer and conicity, temperature.
#pragma once

#include "tread/vehicle.h"
#include "tyre/four_tyres.h"

namespace tread {

// Ply-steer and conicity, in the motions that the tyres' formulas are given.
void shiftMotions(PerWheel<TyreMotion>& begin, PerWheel<TyreMotion>& end, const Vehicle& vehicle);

// Factors of the tyres at their temperatures.
void applyWarmth(PerWheel<TyreFactors>& factors, const PerWheel<WheelState>& wheels, const Vehicle& vehicle);

// Heats the tyres by the power of their slip at the end of the step, and cools them.
void warmTyres(PerWheel<WheelState>& wheels, const Vehicle& vehicle, double dt);

}  // namespace tread
