// Velocities of a car whose position and heading were measured, by motion capture or satellite navigation.
#pragma once

#include <string_view>

#include "log/log.h"

namespace tread::recording {

// Source of what follows from position.x, position.y and position.heading. That of position.x@gps is gps.
inline constexpr std::string_view kPositionSource = "position";

// Adds for each measured position the channels of further instruments that follow from it: chassis.vx@position and
// chassis.vy@position of the tracked point along the axes of the heading, and chassis.yaw_rate@position. Each value is
// a difference quotient between the neighbouring samples, so that the mean of a block is the displacement over the
// block: independent noise s of a position becomes noise s/block of a velocity. Between repeated values, of a slower
// source, the position is taken to move evenly. Without heading only the speed is known; it is taken for vx.
void addVelocities(Log& log);

}  // namespace tread::recording
