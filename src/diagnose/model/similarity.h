// Sizes of effects and usual tolerances are stated for road cars. For a car of another scale they become those of a
// similar car: lengths follow the wheelbase, forces the mass.
#pragma once

#include <string_view>

#include "tread/vehicle.h"

namespace tread::diagnose::model {

// A size in this unit for this car. Unchanged for road cars, and where the unit holds no length, mass or force: delays,
// speeds, accelerations, angles and shares do not depend on the scale.
double atScaleOf(const VehicleParams& car, double size, std::string_view unit);

}  // namespace tread::diagnose::model
