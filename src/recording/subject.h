// Everything that a diagnosis may change: car, road, wind, and the instruments that recorded the car. One struct, so
// that each number has one path ("mass", "road.grade", "wind.speed", "instruments.yaw_rate.delay").
#pragma once

#include <string_view>

#include "recording/instruments.h"
#include "scenario/wind.h"
#include "tread/describe.h"
#include "tread/road_params.h"
#include "tread/vehicle.h"
#include "vehicle/fields.h"

namespace tread::recording {

struct Subject {
    VehicleParams vehicle;
    RoadParams road;
    WindParams wind;
    Instruments instruments;

    // The numbers of the car keep the paths of the vehicle file.
    static constexpr void describe(auto& self, auto&& field) {
        VehicleParams::describe(self.vehicle, field);
        field(TREAD_FIELD(road), About{"", "road"});
        field(TREAD_FIELD(wind), About{"", "wind"});
        field(TREAD_FIELD(instruments), About{"", "instruments that recorded the car"});
    }
};

// The number at a path; nullptr when there is none. The pointer is valid until the subject is moved or resized.
double* numberAt(Subject& subject, std::string_view path);

}  // namespace tread::recording

extern template void tread::detail::FieldsOf<tread::recording::Subject>::addNumbers(tread::recording::Subject&,
                                                                                    const std::string&,
                                                                                    std::vector<tread::Number>&);
