// A car from a text, and its parameters by their paths.
#pragma once

#include <string>
#include <string_view>

#include "tread/vehicle.h"

namespace tread::host {

// As loadVehicle() from a file of that name; files that the text includes are looked for beside it. Throws LoadError.
VehicleParams vehicleOfText(std::string_view text, const std::string& file);

// Sets the field at a path ("mass", "front.suspension.spring") to what could stand in a file: "1400", "1.4 t". Throws
// LoadError, and then leaves the car as it was.
void setParameter(VehicleParams& car, std::string_view path, std::string_view value);

}  // namespace tread::host
