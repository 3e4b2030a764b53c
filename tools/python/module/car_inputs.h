// What a car that is stepped starts from: its file with settings, and its road.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tread/road.h"
#include "tread/vehicle.h"

namespace tread::python {

// Throws LoadError. `vehicle` may be the bare name of a shipped car.
VehicleParams readCar(const std::string& vehicle, const std::vector<std::string>& settings);

// A road of these settings, for example "friction=0.4"; without any: a plane.
std::shared_ptr<Road> roadOf(const std::vector<std::string>& settings);

}  // namespace tread::python
