// modelDescription.xml of an FMU: what a master knows of it.
#pragma once

#include <string>
#include <string_view>

#include "tread/vehicle.h"

namespace tread::fmu {

enum class FmiVersion { fmi2, fmi3 };

// "2.0", "3.0"
std::string_view nameOf(FmiVersion version);

// Of a car; `car_text` is its file in the resources.
std::string modelDescription(const VehicleParams& car, std::string_view car_text, FmiVersion version);

}  // namespace tread::fmu
