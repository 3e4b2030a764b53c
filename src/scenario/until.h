// The events that end a phase.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/did_you_mean.h"
#include "scenario/expression/expression_text.h"
#include "tread/describe.h"
#include "tread/vehicle_output.h"

namespace tread {

// A phase ends with the first of these that comes true.
struct Until {
    std::optional<double> duration;
    std::optional<double> time;
    std::optional<double> speed_below;
    std::optional<double> speed_above;
    std::optional<double> lateral_acceleration_above;
    std::optional<double> lateral_acceleration_below;
    std::optional<double> sideslip_above;
    std::optional<double> steering_above;
    std::optional<double> distance;
    std::optional<double> x_above;
    std::optional<double> x_below;
    std::optional<double> y_above;
    std::optional<double> y_below;
    std::optional<double> after_steering;
    std::optional<double> laps;
    ExpressionText when = {};
    bool yaw_rate_zero = false;
    bool drive_end = false;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(duration), About{"s", "time since the phase began", kPositive}.usually(0.001, 2e5));
        field(TREAD_FIELD(time), About{"s", "time since the manoeuvre began", kPositive}.usually(0.001, 2e5));
        field(TREAD_FIELD(speed_below), About{"m/s", "forward speed falls below this", kAny}.usually(-20, 100));
        field(TREAD_FIELD(speed_above), About{"m/s", "forward speed rises above this", kNonNegative}.usually(0, 100));
        field(TREAD_FIELD(lateral_acceleration_above),
              About{"m/s2", "magnitude of the lateral acceleration rises above this", kPositive}.usually(0.01, 30));
        field(TREAD_FIELD(lateral_acceleration_below),
              About{"m/s2", "magnitude of the lateral acceleration falls below this", kPositive}.usually(0.01, 30));
        field(TREAD_FIELD(sideslip_above),
              About{"rad", "magnitude of the sideslip angle rises above this", kPositive}.usually(0.001, 1.6));
        field(TREAD_FIELD(steering_above),
              About{"rad", "magnitude of the steering-wheel angle rises above this", kPositive}.usually(0.001, 20));
        field(TREAD_FIELD(distance), About{"m", "distance since the phase began", kPositive}.usually(0.05, 1e5));
        field(TREAD_FIELD(x_above), About{"m", "the car is farther along x than this"}.unjudged());
        field(TREAD_FIELD(x_below), About{"m", "the car is not as far along x as this"}.unjudged());
        field(TREAD_FIELD(y_above), About{"m", "the car is farther to the left, along y, than this"}.unjudged());
        field(TREAD_FIELD(y_below), About{"m", "the car is farther to the right, along y, than this"}.unjudged());
        field(TREAD_FIELD(after_steering),
              About{"s", "time since the steering of the phase came to its end: a ramp, sine or pulse is complete",
                    kNonNegative}
                  .usually(0.001, 1000));
        field(TREAD_FIELD(laps),
              About{"-", "laps of the course that are complete; of an open course 1: its end", kPositive}.usually(
                  1, 1000));
        field(TREAD_FIELD(when),
              About{"",
                    "condition on channels of the log and their rates of change, e.g. \"abs(rate(chassis.roll)) < 1.5 "
                    "deg/s\" (see tread describe expressions)"});
        field(TREAD_FIELD(yaw_rate_zero), About{"", "the yaw rate passes through zero during the phase"});
        field(TREAD_FIELD(drive_end), About{"", "the drive that the scenario repeats (drive) ends"});
    }

    static void check(const auto& self, auto&& complain) {
        std::vector<std::string_view> names;
        bool any = false;
        describe(self, [&](std::string_view name, const auto& value, const About&) {
            names.push_back(name);
            any = any || static_cast<bool>(value);
        });
        if (any) return;
        complain("duration",
                 "found no condition, expected at least one (" + listed(names) + "), or the phase would never end");
    }
};
static_assert(describesEveryMember<Until>());

// What a phase has seen so far.
struct Observed {
    ChassisOutput car;
    double steering_wheel_angle = 0;  // rad
    double distance = 0;              // m, since the phase began
    double yaw_rate_before = 0;       // rad/s, one look earlier; 0 in the first look of a phase
    double laps = 0;                  // of the course, since the start
    bool condition = false;           // `when` is met
};

// Whether an event other than by the clock has come true.
bool happened(const Until& until, const Observed& seen);

// What is waited for, in words.
std::string wordsOf(const Until& until);

// Three to four digits for a message; what is next to nothing is 0.
std::string shortNumber(double value);

}  // namespace tread
