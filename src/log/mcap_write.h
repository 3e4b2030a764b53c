// A log as MCAP file, for Foxglove, PlotJuggler and ROS 2: one topic for each group of channels (chassis.yaw_rate is
// the field yaw_rate of /chassis, wheel.front_left.spin the field spin of /wheel/front_left, chassis.yaw_rate@can the
// field yaw_rate of /can/chassis), one message per topic and sample, in JSON. The JSON schema of a topic has the name
// of each channel as title and its unit as description. Values that are not finite are left out.
#pragma once

#include <functional>
#include <string_view>

#include "log/log.h"

namespace tread {

// Log times are nanoseconds; those of a log that begins before 0 count from its first sample. Equal logs give equal
// bytes, which `take` gets piece by piece. `file` names the log in the LoadError for times that MCAP cannot hold;
// `program` ("tread 1.2.3") is said to have written the file.
void writeMcap(const Log& log, std::string_view file, std::string_view program,
               const std::function<void(std::string_view)>& take);

// How the program of a file begins that tread has written.
inline constexpr std::string_view kMcapOfTread = "tread ";

}  // namespace tread
