// The columns of a log.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "log/log.h"
#include "tread/describe.h"
#include "tread/problem.h"
#include "tread/vehicle_output.h"

namespace tread {

// What a car was told to do by a machine, in a recorded log.
struct Command {
    double force = 0;
    double acceleration = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(force), About{"N", "commanded longitudinal force of the tyres, positive forward"});
        field(TREAD_FIELD(acceleration), About{"m/s2", "commanded longitudinal acceleration"});
    }
};
static_assert(describesEveryMember<Command>());

struct LogColumns {
    double time = 0;
    VehicleInput driver;
    Command command;
    VehicleOutput output;

    // The parts of the output are columns of their own: "chassis.vx", not "output.chassis.vx".
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(time), About{"s", "time since the start of the manoeuvre"});
        field(TREAD_FIELD(driver), About{"", "what the driver does"});
        field(TREAD_FIELD(command), About{"", "commands of an automated car, in recorded logs only"});
        VehicleOutput::describe(self.output, field);
    }
};

// The unit of the column of that name; nothing when tread has none of that name.
std::optional<std::string_view> logUnit(const std::string& name);

// Columns that bear one of these names but another unit, as faults of `file`: whoever reads the column would take it
// for something else.
std::vector<Problem> unitFaults(const Log& log, const std::string& file);

}  // namespace tread
