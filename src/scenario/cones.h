// The cones of a course.
#pragma once

#include <vector>

#include "scenario/course.h"

namespace tread {

// Along the edges of the lanes.
std::vector<Point> conesOf(const std::vector<Lane>& course);

}  // namespace tread
