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

// Measured position of a point of the car, in logs of motion capture or satellite navigation only.
struct MeasuredPosition {
    double x = 0, y = 0;
    double heading = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "measured position in any fixed level frame, first axis"});
        field(TREAD_FIELD(y), About{"m", "measured position, second axis, to the left of the first"});
        field(TREAD_FIELD(heading), About{"rad", "measured heading, from the first axis to the left"});
    }
};
static_assert(describesEveryMember<MeasuredPosition>());

struct LogColumns {
    double time = 0;
    VehicleInput driver;
    Command command;
    VehicleOutput output;
    MeasuredPosition position;

    // The parts of the output are columns of their own: "chassis.vx", not "output.chassis.vx".
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(time), About{"s", "time since the start of the manoeuvre"});
        field(TREAD_FIELD(driver), About{"", "what the driver does"});
        field(TREAD_FIELD(command), About{"", "commands of an automated car, in recorded logs only"});
        VehicleOutput::describe(self.output, field);
        field(TREAD_FIELD(position), About{"", "measured position of the car"});
    }
};

// A channel of a further instrument bears the word for its source behind @: chassis.yaw_rate@can.
std::string_view quantityOf(std::string_view channel);  // "chassis.yaw_rate"
std::string_view sourceOf(std::string_view channel);    // "can"; empty for the first instrument

// The unit of the column of that name; nothing when tread has none of that name.
std::optional<std::string_view> logUnit(const std::string& name);

// Columns that bear one of these names but another unit, as faults of `file`: whoever reads the column would take it
// for something else.
std::vector<Problem> unitFaults(const Log& log, const std::string& file);

}  // namespace tread
