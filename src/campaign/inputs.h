// All that the runs of a campaign depend on, resolved: kept in the result folder, so that the folder alone suffices to
// go on, and so that results of another campaign or of another program are never mixed in.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign_file.h"
#include "scenario/scenario.h"
#include "tread/describe.h"
#include "tread/vehicle.h"
#include "vehicle/fields.h"

namespace tread::campaign {

struct NamedVehicle {
    std::string name;
    VehicleParams vehicle;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of its file without .yaml"});
        field(TREAD_FIELD(vehicle), About{"", "the car, includes and settings resolved"});
    }
};
static_assert(describesEveryMember<NamedVehicle>());

struct NamedScenario {
    std::string name;
    Scenario scenario;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of its file without .yaml"});
        field(TREAD_FIELD(scenario), About{"", "the scenario, settings and conditions resolved"});
    }
};
static_assert(describesEveryMember<NamedScenario>());

struct CampaignInputs {
    std::string tread_version;
    std::string program;
    CampaignFile campaign;
    std::vector<NamedVehicle> vehicles = {};
    std::vector<NamedScenario> scenarios = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(tread_version), About{"", "version of the program"});
        field(TREAD_FIELD(program), About{"", "hash of the sources that compute a run"});
        field(TREAD_FIELD(campaign), About{"", "the campaign"});
        field(TREAD_FIELD(vehicles), About{"", "its cars"});
        field(TREAD_FIELD(scenarios), About{"", "its scenarios"});
    }
};
static_assert(describesEveryMember<CampaignInputs>());

}  // namespace tread::campaign
