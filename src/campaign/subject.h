// Car and scenario of a run, and their fields by path.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/scenario.h"
#include "tread/describe.h"
#include "tread/vehicle.h"
#include "vehicle/fields.h"

namespace tread::campaign {

// The fields that a factor can name: those of the car under their own names, those of the scenario under "scenario.".
struct Subject {
    VehicleParams vehicle;
    Scenario scenario;

    static constexpr void describe(auto& self, auto&& field) {
        VehicleParams::describe(self.vehicle, field);
        field(TREAD_FIELD(scenario), About{"", "scenario"});
    }
    static void check(const auto& self, auto&& complain) { VehicleParams::check(self.vehicle, complain); }
};

struct FieldFound {
    bool exists = false;
    bool is_number = false;
    double value = std::numeric_limits<double>::quiet_NaN();  // of a number that is there
    About about{"", ""};
};

// The field at a path. Changes the number when `set` is given; an optional part that is absent is made on the way.
FieldFound fieldAt(Subject& subject, const std::string& path, const double* set = nullptr);

// Sets fields, each path=value, as --set does. Throws LoadError that names `where`.
void setFields(Subject& subject, std::span<const std::string> assignments, const std::string& where);
void setFields(VehicleParams& vehicle, std::span<const std::string> assignments, const std::string& where);

// Throws LoadError that names `where` when a number is beyond its limits or contradicts another.
void expectSound(Subject& subject, const std::string& where);

// Which command lists the paths beside this one, for messages.
std::string listingOf(std::string_view path);

// What to say of a path that no field has.
std::string unknownPath(const std::string& path);

// Seeds of road, steering and sensors: how many there are, and others in their place for each repetition.
int seedsIn(const Scenario& scenario);
void reseed(Scenario& scenario, std::uint64_t seed, std::uint64_t repetition);

}  // namespace tread::campaign
