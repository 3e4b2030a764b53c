// A manoeuvre: where the car starts, on which road, what the driver does phase by phase, when it ends, what is logged.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields/visitors.h"
#include "scenario/accept.h"
#include "scenario/course.h"
#include "scenario/own_metric.h"
#include "scenario/sensor.h"
#include "scenario/series.h"
#include "scenario/signals.h"
#include "scenario/until.h"
#include "scenario/wind.h"
#include "tread/describe.h"
#include "tread/road_params.h"

namespace tread {

// The car starts in equilibrium: settled on its suspension, wheels rolling, the throttle that holds the speed.
struct StartParams {
    double speed = 0;
    double heading = 0;
    double brake = 0;
    double parking_brake = 0;
    double drop = 0;
    double run_in = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(speed), About{"m/s", "forward speed", kNonNegative}.usually(0, 70));
        field(TREAD_FIELD(heading), About{"rad", "direction, 0 along x, positive to the left"}.usually(-6.3, 6.3));
        field(TREAD_FIELD(brake), About{"-", "brake pedal", kFraction});
        field(TREAD_FIELD(parking_brake), About{"-", "parking brake", kFraction});
        field(TREAD_FIELD(drop),
              About{"m", "height above equilibrium from which the car is dropped", kNonNegative}.usually(0, 3));
        field(TREAD_FIELD(run_in),
              About{"s",
                    "time of the first phase that passes before the manoeuvre's time 0 and is not logged; a replay of "
                    "a log that begins in a turn sets it",
                    kNonNegative}
                  .usually(0, 600));
    }

    static void check(const auto& self, auto&& complain) {
        if (self.speed > 0 && self.brake + self.parking_brake > 0)
            complain(self.brake > 0 ? "brake" : "parking_brake",
                     "a car that starts at a speed cannot have its brakes on; put the braking into a phase");
    }
};
static_assert(describesEveryMember<StartParams>());

struct Phase {
    std::string name;
    SteeringSignal steering;
    ThrottleSignal throttle;
    PedalSignal brake;
    PedalSignal clutch;
    PedalSignal parking_brake;
    Until until;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name, for messages"});
        field(TREAD_FIELD(steering), About{"", "steering wheel, positive to the left"});
        field(TREAD_FIELD(throttle), About{"", "throttle pedal"});
        field(TREAD_FIELD(brake), About{"", "brake pedal"});
        field(TREAD_FIELD(clutch), About{"", "clutch pedal, 1 separates engine and gearbox"});
        field(TREAD_FIELD(parking_brake), About{"", "parking brake"});
        field(TREAD_FIELD(until), About{"", "when the phase ends"});
    }
};
static_assert(describesEveryMember<Phase>());

struct LogParams {
    double rate = 100;
    std::vector<std::string> channels;
    std::vector<SensorParams> sensors = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(rate),
              About{"1/s", "rows per second (rounded to a whole number of steps per row)", kPositive}.usually(0.5,
                                                                                                              20000));
        field(TREAD_FIELD(channels), About{"", "names of the channels to log, * for any characters; none: all"});
        field(TREAD_FIELD(sensors), About{"", "sensors, logged beside the channels as sensor.<name>"});
    }
};
static_assert(describesEveryMember<LogParams>());

struct Scenario {
    std::string title;
    std::string description;
    std::string manoeuvre;
    double step = 0.001;
    double substep = 0.001;
    double time_limit = 120;
    RoadParams road;
    WindParams wind;
    StartParams start;
    std::string drive;
    CourseParams course;
    std::vector<std::string> car_settings = {};
    std::vector<Phase> phases;
    LogParams log;
    SeriesParams series;
    std::vector<OwnMetric> metrics = {};
    Acceptance accept = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(title), About{"", "what the manoeuvre is, in a few words"});
        field(TREAD_FIELD(description),
              About{"", "the standard or source that it follows, and where its numbers come from"});
        field(TREAD_FIELD(manoeuvre),
              About{"", "whose metrics are computed (see tread describe metrics); empty: none"});
        field(TREAD_FIELD(step), About{"s", "time step of the Bullet world", {1e-5, 0.05}});
        field(
            TREAD_FIELD(substep),
            About{"s", "longest step of the car within one of the world: larger is cheaper and coarser", {1e-4, 0.02}});
        field(TREAD_FIELD(time_limit),
              About{"s", "time after which a manoeuvre that did not end has failed", kPositive}.usually(0.01, 5e5));
        field(TREAD_FIELD(road), About{"", "road"});
        field(TREAD_FIELD(wind), About{"", "wind"});
        field(TREAD_FIELD(start), About{"", "start"});
        field(TREAD_FIELD(drive),
              About{"",
                    "log (CSV) of a drive that is repeated, measured or simulated: replays without a file read it, "
                    "the start has its speed; `tread run --log FILE` names it"});
        field(TREAD_FIELD(course), About{"", "path and lanes of the manoeuvre"});
        field(TREAD_FIELD(car_settings),
              About{"", "what this manoeuvre changes on the car, each path=value: brakes.anti_lock.enabled=true"});
        field(TREAD_FIELD(phases), About{"", "what the driver does, one phase after the other"});
        field(TREAD_FIELD(log), About{"", "what is logged"});
        field(TREAD_FIELD(series), About{"", "further runs, when one cannot answer the question"});
        field(TREAD_FIELD(metrics), About{"", "metrics of your own, in addition to those of the manoeuvre"});
        field(TREAD_FIELD(accept),
              About{"",
                    "what the metrics must be, each `name: condition`: \"< 40 m\", \"= 0\", \"30 .. 40 m\", "
                    "\"38.2 m +- 2 %\"; a number without unit is in that of the metric"});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.phases.empty())
            complain("phases", "found no phase, expected at least one that says what the driver does and until when");
        if (self.course.line.given() || !self.course.path.empty() || !self.course.sections.empty()) return;
        for (const Phase& phase : self.phases) {
            if (!std::holds_alternative<FollowPath>(phase.steering) && !phase.until.laps) continue;
            complain("course", "found no path, expected sections, a path or a line: a driver follows it");
            return;
        }
    }
};
static_assert(describesEveryMember<Scenario>());
extern template struct detail::FieldsOf<Scenario>;

}  // namespace tread
