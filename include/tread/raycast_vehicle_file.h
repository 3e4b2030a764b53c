// Tyres and suspension of a vehicle file under a RaycastVehicle. Needs C++20 and Eigen.
#pragma once

#include <filesystem>

#include "tread/raycast_vehicle.h"
#include "tread/vehicle.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// From the file come tyres, wheel inertias, springs, dampers, anti-roll bars and bump stops; mass, geometry, steering
// angles, engine and brake forces stay the game's. Friction slip counts no more. Holds from the next step on.
TREAD_API void setVehicle(RaycastVehicle& vehicle, const VehicleParams& params);
// The same from a file; LoadError.
TREAD_API void setVehicle(RaycastVehicle& vehicle, const std::filesystem::path& file);

// Tyre of one wheel from the next step on, in place of what tuning or file say. std::out_of_range: no such wheel.
TREAD_API void setTyre(RaycastVehicle& vehicle, int wheel, const TyreParams& tyre);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
