// One channel of a log over another: the figure that most tests of handling ask for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "report/svg.h"

namespace tread {

struct PlotAxis {
    std::string_view channel;
    std::string_view label;
    std::string_view unit;  // wanted on the chart, where the report knows the conversion
};

// The quantities that several figures share.
inline constexpr PlotAxis kSteeringWheel{"driver.steering_wheel_angle", "steering-wheel angle", "deg"};
inline constexpr PlotAxis kSteeringWheelTorque{"steering.torque", "steering-wheel torque", "N m"};
inline constexpr PlotAxis kForwardSpeed{"chassis.vx", "speed", "km/h"};
inline constexpr PlotAxis kLongitudinal{"chassis.ax", "longitudinal acceleration", "m/s2"};
inline constexpr PlotAxis kLateral{"chassis.ay", "lateral acceleration", "m/s2"};
inline constexpr PlotAxis kYawRate{"chassis.yaw_rate", "yaw rate", "deg/s"};
inline constexpr PlotAxis kSideslip{"chassis.sideslip", "sideslip angle", "deg"};
inline constexpr PlotAxis kCourseDistance{"course.distance", "distance along the course", "m"};
inline constexpr PlotAxis kCrossTrack{"course.cross_track_error", "distance from the path", "m"};
inline constexpr PlotAxis kRoll{"chassis.roll", "roll angle", "deg"};

// m/s: below, a car comes to rest and rocks on its tyres, which says nothing about slip and used friction.
inline constexpr double kStanding = 1;

struct PlotValues {
    std::vector<double> values;  // in `unit`
    std::string unit;
};

// Nothing when the log lacks the channel, or misses some of its values.
std::optional<PlotValues> valuesFor(const Log& log, const PlotAxis& axis);

// Nothing when the log lacks one of the two.
std::optional<Chart> crossPlot(const Log& log, std::string title, const PlotAxis& x, const PlotAxis& y);

// The channel of that name when it has a value for every moment of the log, otherwise nullptr.
const Channel* completeChannel(const Log& log, std::string_view name);

}  // namespace tread
