// Channels of a log as series, with one clear error for all that are missing.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "metrics/metrics.h"
#include "metrics/series.h"

namespace tread {

inline constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kGravity = 9.80665;  // m/s2, the g in deg/g
inline constexpr double kDegrees = 57.29577951308232;
inline constexpr double kKmh = 1 / 3.6;  // m/s
inline constexpr double kMillimetres = 1000;
inline constexpr std::array<std::string_view, 4> kWheelNames{"front_left", "front_right", "rear_left", "rear_right"};
// Half width of the smoothing of measured responses: keeps 2 Hz to 1 %, takes out two thirds of white noise at 100 Hz.
inline constexpr double kResponseHalfWidth = 0.075;  // s
inline constexpr double kSpeedHalfWidth = 0.1;       // s, of the speed of a car that is braked or accelerated
// What counts as nothing done by the driver, and how closely a path is looked at.
inline constexpr double kRestingFoot = 0.02;              // of a pedal: less is a resting foot
inline constexpr double kFixedSteering = 1.0 / kDegrees;  // rad by which the steering wheel may move
inline constexpr double kWayStep = 0.05;                  // m of way between the places at which the car is looked at

// The channels in the order of `names`. As notFound when any is missing or holds values that are not finite.
std::vector<TimeSeries> channels(const Log& log, const std::vector<std::string_view>& names);
// The same for a channel that the manoeuvre can do without.
std::optional<TimeSeries> channelIfThere(const Log& log, std::string_view name);

// Magnitude of the horizontal velocity; of its forward part when there is no chassis.vy.
TimeSeries speed(const Log& log);

// chassis.sideslip, or the angle of the velocity when only chassis.vy is logged.
std::optional<TimeSeries> sideslip(const Log& log);

// Mean over left and right of a quantity of the front wheels, less that of the rear wheels.
std::optional<TimeSeries> frontLessRear(const Log& log, std::string_view quantity);

// Ends the search for a manoeuvre: why it is not in the log, without its name.
[[noreturn]] void notFound(const std::string& why);

}  // namespace tread
