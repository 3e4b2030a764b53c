// What a diagnosis may change: the car, the road and the air around it, and the instruments that observed it. One
// struct, so that every number has one path ("mass", "road.grade", "wind.speed", "instruments.yaw_rate.delay").
#pragma once

#include <string_view>

#include "recording/instruments.h"
#include "scenario/wind.h"
#include "tread/describe.h"
#include "tread/road_params.h"
#include "tread/vehicle.h"

namespace tread::recording {

struct Subject {
    VehicleParams vehicle;
    RoadParams road;
    WindParams wind;
    Instruments instruments;

    // The car's numbers keep the paths that they have everywhere.
    static constexpr void describe(auto& self, auto&& field) {
        VehicleParams::describe(self.vehicle, field);
        field(TREAD_FIELD(road), About{"", "road"});
        field(TREAD_FIELD(wind), About{"", "wind"});
        field(TREAD_FIELD(instruments), About{"", "instruments that observed the car"});
    }
};

// The number at a path; nullptr when there is none. Valid as long as the subject is neither moved nor resized.
double* numberAt(Subject& subject, std::string_view path);

}  // namespace tread::recording
