// Is the car still where a car can be?
#pragma once

#include "tread/vehicle_output.h"

namespace tread {

// Throws SimulationError naming the channel, its value and the time.
void checkHealth(const VehicleOutput& output, double time);

}  // namespace tread
