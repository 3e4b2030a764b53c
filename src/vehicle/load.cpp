#include "tread/load.h"

#include "base/yaml/read.h"
#include "base/yaml/write.h"
#include "vehicle/fields.h"

namespace tread {

VehicleParams loadVehicle(const std::filesystem::path& file) {
    return readYaml<VehicleParams>(file);
}

TyreParams loadTyre(const std::filesystem::path& file) {
    return readYaml<TyreParams>(file);
}

std::string vehicleYaml(const VehicleParams& params) {
    return writeYaml(params);
}

}  // namespace tread
