// Reading and writing the files that describe a car.
#pragma once

#include <filesystem>
#include <string>

#include "tread/api.h"
#include "tread/problem.h"
#include "tread/vehicle.h"

namespace tread {

// All of these throw LoadError with every fault of the file (file, line, column, what was found and expected).
TREAD_API VehicleParams loadVehicle(const std::filesystem::path& file);

// YAML, or a .tir tyre property file; what the 1997 model cannot represent of that is named in the tyre's notes.
TREAD_API TyreParams loadTyre(const std::filesystem::path& file);

// The resolved vehicle as YAML: includes inlined, SI numbers with their units in comments.
TREAD_API std::string vehicleYaml(const VehicleParams& params);

}  // namespace tread
