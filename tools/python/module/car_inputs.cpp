#include "car_inputs.h"

#include "base/yaml/setting.h"
#include "kind_of_file.h"
#include "shipped_file.h"
#include "tread/load.h"
#include "tread/road_surface.h"
#include "vehicle/fields.h"

namespace tread::python {

VehicleParams readCar(const std::string& vehicle, const std::vector<std::string>& settings) {
    const std::string file = program::shippedFile(vehicle, "vehicles");
    program::expectKind(file, {"vehicle"});
    VehicleParams car = loadVehicle(file);
    applySettings(car, settings, "settings",
                  [](std::string_view) -> std::string { return "`tread describe vehicle` lists all paths"; });
    return car;
}

std::shared_ptr<Road> roadOf(const std::vector<std::string>& settings) {
    RoadParams params;
    applySettings(params, settings, "road", [](std::string_view) -> std::string {
        return "`tread describe scenario` lists all paths after \"road.\"";
    });
    return makeRoad(params);
}

}  // namespace tread::python
