// All that a run depends on, resolved: written beside its log.
#pragma once

#include <string>

#include "scenario/scenario.h"
#include "tread/vehicle.h"

namespace tread {

struct RunRecord {
    std::string tread_version;
    int seed = 0;
    VehicleParams vehicle;
    Scenario scenario;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(tread_version), About{"", "version of the program"});
        field(TREAD_FIELD(seed), About{"", "seed of everything random that has none of its own"});
        field(TREAD_FIELD(vehicle), About{"", "the car, includes and settings resolved"});
        field(TREAD_FIELD(scenario), About{"", "the scenario, settings resolved"});
    }
};
static_assert(describesEveryMember<RunRecord>());

}  // namespace tread
