// The columns of a log.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/fields/visitors.h"
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

// Where the run stands in its scenario, in simulated logs only.
struct ManoeuvreOutput {
    double phase = 1;
    double phase_start = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(phase), About{"-", "number of the phase of the scenario, from 1"});
        field(TREAD_FIELD(phase_start), About{"s", "time at which that phase began"});
    }
};
static_assert(describesEveryMember<ManoeuvreOutput>());

// Where the car is on the course, in simulated logs of scenarios with one.
struct CourseOutput {
    double distance = 0;
    double cross_track_error = 0;
    double speed = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(distance), About{"m",
                                           "distance along the path of the course to the point nearest to the centre "
                                           "of gravity; continues over laps"});
        field(TREAD_FIELD(cross_track_error),
              About{"m", "distance of the centre of gravity from the path, positive to its left"});
        field(TREAD_FIELD(speed), About{"m/s", "target speed of the course there; 0: none"});
    }
};
static_assert(describesEveryMember<CourseOutput>());

struct LogColumns {
    double time = 0;
    VehicleInput driver;
    Command command;
    VehicleOutput output;
    MeasuredPosition position;
    ManoeuvreOutput manoeuvre;
    CourseOutput course;

    // The parts of the output are columns of their own: "chassis.vx", not "output.chassis.vx".
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(time), About{"s", "time since the start of the manoeuvre"});
        field(TREAD_FIELD(driver), About{"", "what the driver does"});
        field(TREAD_FIELD(command), About{"", "commands of an automated car, in recorded logs only"});
        VehicleOutput::describe(self.output, field);
        field(TREAD_FIELD(position), About{"", "measured position of the car"});
        field(TREAD_FIELD(manoeuvre), About{"", "place in the scenario"});
        field(TREAD_FIELD(course), About{"", "place on the course"});
    }
};

extern template void detail::FieldsOf<LogColumns>::addNumbers(LogColumns&, const std::string&, std::vector<Number>&);

// A channel of a further instrument bears the word for its source behind @: chassis.yaw_rate@can.
std::string_view quantityOf(std::string_view channel);  // "chassis.yaw_rate"
std::string_view sourceOf(std::string_view channel);    // "can"; empty for the first instrument

// The unit of the column of that name; nothing when tread has none of that name.
std::optional<std::string_view> logUnit(const std::string& name);

// Columns that bear one of these names but another unit, as faults of `file`: whoever reads the column would take it
// for something else.
std::vector<Problem> unitFaults(const Log& log, const std::string& file);

}  // namespace tread
