// Numbers of a car that are plausible each for itself and not beside the others: a spring for the load that it carries,
// a mass for the size of the car.
#pragma once

#include <vector>

#include "base/fields/implausible.h"
#include "tread/vehicle.h"

namespace tread {

// Only what the numbers themselves do not show: where one of those that are compared is implausible or missing, nothing
// is said about the others.
std::vector<Implausible> implausibleRelations(const VehicleParams& car);

}  // namespace tread
