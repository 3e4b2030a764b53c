// Directions, which a recorder may count within one turn: a step from pi to -pi is no motion.
#pragma once

#include <string_view>
#include <vector>

namespace tread {

// Whether a channel shows a direction in the plane: chassis.yaw and position.heading, of any source.
bool isDirection(std::string_view channel);

// The angles, rad, turned by whole turns so that no step exceeds half of one. What is not finite is passed over.
std::vector<double> continuous(std::vector<double> angles);

}  // namespace tread
