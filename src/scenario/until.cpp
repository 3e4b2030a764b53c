#include "scenario/until.h"

#include <cmath>
#include <cstdio>

namespace tread {

std::string shortNumber(double value) {
    constexpr double kNothing = 5e-4;  // of any unit
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", std::abs(value) < kNothing ? 0 : value);
    return text;
}

bool happened(const Until& until, const Observed& seen) {
    const ChassisOutput& car = seen.car;
    const auto above = [](double value, const std::optional<double>& limit) { return limit && value > *limit; };
    const auto below = [](double value, const std::optional<double>& limit) { return limit && value < *limit; };
    return below(car.vx, until.speed_below) || above(car.vx, until.speed_above) ||
           above(std::abs(car.ay), until.lateral_acceleration_above) ||
           below(std::abs(car.ay), until.lateral_acceleration_below) ||
           above(std::abs(car.sideslip), until.sideslip_above) ||
           above(std::abs(seen.steering_wheel_angle), until.steering_above) || above(seen.distance, until.distance) ||
           above(car.x, until.x_above) || below(car.x, until.x_below) || above(car.y, until.y_above) ||
           below(car.y, until.y_below) || (until.laps && seen.laps >= *until.laps) || (until.when && seen.condition) ||
           (until.yaw_rate_zero && car.yaw_rate * seen.yaw_rate_before < 0);
}

std::string wordsOf(const Until& until) {
    std::vector<std::string> ends;
    const auto say = [&](const std::optional<double>& limit, const char* what, const char* unit) {
        if (limit) ends.push_back(what + shortNumber(*limit) + " " + unit);
    };
    say(until.speed_below, "a speed below ", "m/s");
    say(until.speed_above, "a speed above ", "m/s");
    say(until.lateral_acceleration_above, "a lateral acceleration above ", "m/s2");
    say(until.lateral_acceleration_below, "a lateral acceleration below ", "m/s2");
    say(until.sideslip_above, "a sideslip angle above ", "rad");
    say(until.steering_above, "a steering-wheel angle above ", "rad");
    say(until.distance, "a distance of ", "m");
    say(until.x_above, "x above ", "m");
    say(until.x_below, "x below ", "m");
    say(until.y_above, "y above ", "m");
    say(until.y_below, "y below ", "m");
    say(until.laps, "laps: ", "");
    if (until.when) ends.push_back("\"" + until.when.text + "\"");
    if (until.after_steering) ends.push_back("the end of the steering");
    if (until.yaw_rate_zero) ends.push_back("a yaw rate of zero");
    say(until.time, "the time ", "s");
    if (until.duration) ends.push_back(shortNumber(*until.duration) + " s to pass");
    return listed(std::vector<std::string_view>(ends.begin(), ends.end()));
}

}  // namespace tread
