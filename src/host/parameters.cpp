#include "host/parameters.h"

#include "base/concat.h"
#include "base/setting.h"

namespace tread::host {
namespace {

std::string listing(std::string_view) {
    return "`tread describe vehicle` lists all paths";
}

}  // namespace

VehicleParams vehicleOfText(std::string_view text, const std::string& file) {
    return readYamlText<VehicleParams>(text, file);
}

void setParameter(VehicleParams& car, std::string_view path, std::string_view value) {
    const std::string assignment = concat({path, "=", value});
    applySettings(car, std::span(&assignment, 1), "parameter", listing);
}

}  // namespace tread::host
