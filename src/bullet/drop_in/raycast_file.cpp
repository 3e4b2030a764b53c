#include <stdexcept>

#include "bullet/drop_in/raycast_parts.h"
#include "tread/load.h"
#include "tread/raycast_vehicle_file.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

void setVehicle(RaycastVehicle& vehicle, const VehicleParams& params) {
    auto& car = implementationOf(vehicle);
    car.file = params;
    car.made = false;
}

void setVehicle(RaycastVehicle& vehicle, const std::filesystem::path& file) {
    setVehicle(vehicle, loadVehicle(file));
}

void setTyre(RaycastVehicle& vehicle, int wheel, const TyreParams& tyre) {
    const auto i = static_cast<std::size_t>(wheel);
    if (wheel < 0 || i >= kMostWheels) throw std::out_of_range("tread::setTyre: no such wheel");
    auto& car = implementationOf(vehicle);
    car.own_tyres[i] = tyre;
    car.made = false;
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
