// A car from a text, and its parameters by their paths.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tread/vehicle.h"

namespace tread::host {

// As loadVehicle() from a file of that name; files that the text includes are looked for beside it. Throws LoadError.
VehicleParams vehicleOfText(std::string_view text, const std::string& file);

// Throws LoadError for numbers beyond their limits and for what rules across fields forbid.
void checkParameters(const VehicleParams& car);

// Sets the fields at paths, "path=value" each. Throws LoadError, naming `what` in place of a file, and then leaves the
// car as it was.
void setParameters(VehicleParams& car, std::span<const std::string> assignments, std::string_view what);

// Sets the field at a path ("mass", "front.suspension.spring") to what could stand in a file: "1400", "1.4 t". Throws
// as setParameters() does.
void setParameter(VehicleParams& car, std::string_view path, std::string_view value);

// The number at a path, SI; throws LoadError when there is none.
double parameter(VehicleParams& car, std::string_view path);

}  // namespace tread::host
